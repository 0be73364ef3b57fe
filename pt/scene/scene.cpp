#include "pt/scene/scene.h"

#include "pt/scene/recorder.h"

#include <cmath>

namespace pt {

namespace {

thread_local RayCount ray_count;

// The size of the numbers from which the point of a hit was computed: its rounding error is a
// small multiple of this times 2^-53.
double error_scale(const Primitives& primitives, const Ray& ray, const Hit& hit, Vec3 p) {
  double scale = std::max({max_abs(ray.origin), max_abs(p), hit.t * max_abs(ray.direction)});
  if (!primitives.is_triangle(hit.primitive)) {
    const Sphere& sphere = primitives.sphere(hit.primitive);
    scale = std::max(scale, max_abs(sphere.center) + sphere.radius);
  } else {
    const Triangle& t = primitives.triangle(hit.primitive);
    scale = std::max({scale, max_abs(t.p0), max_abs(t.p1), max_abs(t.p2)});
  }
  return scale;
}

Vec3 unit_geometric_normal(const Primitives& primitives, const Hit& hit) {
  return primitives.is_triangle(hit.primitive)
             ? normalize(geometric_normal(primitives.triangle(hit.primitive)))
             : hit.n;
}

std::optional<Hit> traced(const Scene& scene, const Ray& ray) {
  ++ray_count.closest;
  return scene.tracer.closest(scene.primitives, ray);
}

bool same(const Ray& a, const Ray& b) {
  return a.origin == b.origin && a.direction == b.direction && a.t_min == b.t_min &&
         a.t_max == b.t_max;
}

// If a ray is not the next one on the tape, it is traced.
std::optional<Hit> closest_by_tape(PathTape& tape, const Scene& scene, const Ray& ray) {
  if (tape.mode == PathTape::Mode::record) {
    tape.rays.push_back({ray, traced(scene, ray)});
    return tape.rays.back().hit;
  }
  if (tape.next_light >= tape.enough) return {};
  const bool known = tape.next_ray < tape.rays.size() && same(tape.rays[tape.next_ray].ray, ray);
  return known ? tape.rays[tape.next_ray++].hit : traced(scene, ray);
}

}  // namespace

std::optional<Hit> Scene::closest(const Ray& ray) const {
  return keep_call(
      "closest",
      [&] {
        return recorder.path == nullptr ? traced(*this, ray)
                                        : closest_by_tape(*recorder.path, *this, ray);
      },
      *this, ray);
}

bool Scene::occluded(const Ray& ray) const {
  ++ray_count.occluded;
  return keep_call(
      "occluded", [&] { return tracer.occluded(primitives, ray); }, *this, ray);
}

std::uint32_t Scene::occluded(std::span<const Ray> rays) const {
  ray_count.occluded += static_cast<long long>(rays.size());
  return tracer.occluded(primitives, rays);
}

SurfacePoint surface_point(const Scene& scene, const Ray& ray, const Hit& hit) {
  const Material& front = scene.materials[scene.material_of[hit.primitive]];
  const bool on_triangle = scene.primitives.is_triangle(hit.primitive);
  const Vec3 p = ray.at(hit.t), wo = normalize(-ray.direction);
  const Vec3 n = dot(hit.n, wo) < 0 ? -hit.n : hit.n;
  const Vec3 geometric_normal = unit_geometric_normal(scene.primitives, hit);
  const bool is_front = dot(geometric_normal, wo) > 0;
  const bool has_back = front.behind >= 0;
  const Material& material = is_front || !has_back ? front : scene.materials[front.behind];
  return {p,
          n,
          geometric_normal,
          frame_from_normal(n),
          wo,
          material.albedo,
          is_front || has_back ? material.emission : Rgb{},
          on_triangle ? hit.primitive : -1,
          error_scale(scene.primitives, ray, hit, p)};
}

Rgb background(const Scene& scene, Vec3 direction) {
  Rgb sky;
  if (!(direction.y > 0)) return sky;
  for (const Light& light : scene.lights) {
    if (const auto* ambient = std::get_if<AmbientLight>(&light)) sky += ambient->radiance;
  }
  return sky;
}

RayCount rays_traced() { return ray_count; }

void count_rays(const RayCount& more) {
  ray_count.closest += more.closest;
  ray_count.occluded += more.occluded;
}

}  // namespace pt
