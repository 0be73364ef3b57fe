#include "bench/embree.h"

#include <algorithm>

namespace pt {

namespace {

void add_triangles(RTCDevice device, RTCScene scene, const std::vector<Triangle>& triangles) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* corner = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                             RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                             3 * triangles.size()));
  auto* index = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(unsigned), triangles.size()));
  for (const Triangle& t : triangles) {
    for (const Vec3& p : {t.p0, t.p1, t.p2}) {
      for (int axis = 0; axis < 3; ++axis) *corner++ = static_cast<float>(p[axis]);
    }
  }
  for (unsigned i = 0; i < 3 * triangles.size(); ++i) index[i] = i;
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, 0);
  rtcReleaseGeometry(geometry);
}

void add_spheres(RTCDevice device, RTCScene scene, const std::vector<Sphere>& spheres) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* value = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), spheres.size()));
  for (const Sphere& sphere : spheres) {
    for (int axis = 0; axis < 3; ++axis) *value++ = static_cast<float>(sphere.center[axis]);
    *value++ = static_cast<float>(sphere.radius);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, 1);
  rtcReleaseGeometry(geometry);
}

}  // namespace

Hit triangle_hit(const Primitives& primitives, int primitive, double t, double b1, double b2) {
  const Triangle& triangle = primitives.triangle(primitive);
  const Vec3 n = (1 - b1 - b2) * triangle.n0 + b1 * triangle.n1 + b2 * triangle.n2;
  return {t, normalize(n), primitive};
}

bool EmbreeScene::count_bytes(void* user, ssize_t bytes, bool) {
  static_cast<EmbreeScene*>(user)->bytes_ += bytes;
  return true;
}

EmbreeScene::EmbreeScene(const Primitives& primitives, RTCSceneFlags flags)
    : device_(rtcNewDevice("threads=1")),
      scene_(rtcNewScene(device_)),
      triangle_count_(static_cast<std::uint32_t>(primitives.triangles.size())) {
  rtcSetSceneFlags(scene_, flags);
  margin_ = 0x1p-16 * max_abs(bounds(primitives).extent());
  if (!primitives.triangles.empty()) add_triangles(device_, scene_, primitives.triangles);
  if (!primitives.spheres.empty()) add_spheres(device_, scene_, primitives.spheres);
  rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, this);
  rtcCommitScene(scene_);
}

EmbreeScene::~EmbreeScene() {
  rtcSetDeviceMemoryMonitorFunction(device_, nullptr, nullptr);
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

RTCRay EmbreeScene::convert(const Ray& ray) const {
  RTCRay r{};
  r.org_x = static_cast<float>(ray.origin.x);
  r.org_y = static_cast<float>(ray.origin.y);
  r.org_z = static_cast<float>(ray.origin.z);
  r.dir_x = static_cast<float>(ray.direction.x);
  r.dir_y = static_cast<float>(ray.direction.y);
  r.dir_z = static_cast<float>(ray.direction.z);
  r.tnear = static_cast<float>(std::max(ray.t_min, margin_));
  r.tfar = static_cast<float>(ray.t_max - margin_);
  r.mask = ~0u;
  return r;
}

std::optional<Hit> EmbreeScene::closest(const Primitives& primitives, const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query;
  query.ray = convert(ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_, &context, &query);
  return hit_of(primitives, ray, query);
}

std::optional<Hit> EmbreeScene::hit_of(const Primitives& primitives, const Ray& ray,
                                       const RTCRayHit& query) const {
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const double t = query.ray.tfar;
  if (query.hit.geomID == 1) {
    const Sphere& sphere = primitives.spheres[query.hit.primID];
    const int primitive = static_cast<int>(triangle_count_ + query.hit.primID);
    return Hit{t, normalize(ray.at(t) - sphere.center), primitive};
  }
  return triangle_hit(primitives, static_cast<int>(query.hit.primID), t, query.hit.u, query.hit.v);
}

bool EmbreeScene::occluded(const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay r = convert(ray);
  rtcOccluded1(scene_, &context, &r);
  return r.tfar < 0;
}

std::uint32_t EmbreeScene::occluded8(std::span<const Ray> rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  alignas(32) int valid[8] = {};
  RTCRay8 packet{};
  const std::size_t count = std::min<std::size_t>(rays.size(), 8);
  for (std::size_t i = 0; i < count; ++i) {
    const RTCRay r = convert(rays[i]);
    valid[i] = -1;
    packet.org_x[i] = r.org_x;
    packet.org_y[i] = r.org_y;
    packet.org_z[i] = r.org_z;
    packet.dir_x[i] = r.dir_x;
    packet.dir_y[i] = r.dir_y;
    packet.dir_z[i] = r.dir_z;
    packet.tnear[i] = r.tnear;
    packet.tfar[i] = r.tfar;
    packet.mask[i] = r.mask;
  }
  rtcOccluded8(valid, scene_, &context, &packet);
  std::uint32_t blocked = 0;
  for (std::size_t i = 0; i < count; ++i) {
    blocked |= static_cast<std::uint32_t>(packet.tfar[i] < 0) << i;
  }
  return blocked;
}

}  // namespace pt
