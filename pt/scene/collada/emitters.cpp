#include "pt/scene/collada/emitters.h"

#include "pt/geometry/box.h"

#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace pt {

namespace {

// Corners in files have about seven digits: a parallelogram closes only to this accuracy.
constexpr double kClosing = 1e-6;

// The parallelogram of two triangles that lie on both sides of a shared diagonal and face one way.
std::optional<RectangleLight> parallelogram(const Triangle& a, const Triangle& b, Rgb radiance) {
  const Vec3 normal = geometric_normal(a);
  if (!(dot(normal, geometric_normal(b)) > 0)) return std::nullopt;
  const double tolerance = kClosing * std::sqrt(length(normal));
  const std::array<Vec3, 3> corners{a.p0, a.p1, a.p2};
  const std::array<Vec3, 3> others{b.p0, b.p1, b.p2};
  const auto same = [&](Vec3 p, Vec3 q) { return length(p - q) <= tolerance; };
  for (int i = 0; i < 3; ++i) {
    // p and q are the corners of a and b off the shared diagonal: s to t in a, t to s in b.
    const Vec3 p = corners[i], s = corners[(i + 1) % 3], t = corners[(i + 2) % 3];
    for (int j = 0; j < 3; ++j) {
      const Vec3 q = others[j];
      if (same(others[(j + 1) % 3], t) && same(others[(j + 2) % 3], s) && same(p + q, s + t)) {
        return RectangleLight{0.5 * (s + t), s - p, t - p, normalize(normal), radiance};
      }
    }
  }
  return std::nullopt;
}

}  // namespace

Emitter mesh_emitter(std::span<const Triangle> triangles, Rgb radiance, const std::string& name) {
  Emitter emitter;
  emitter.radiance = radiance;
  emitter.name = name;
  std::vector<MeshLight::Face> faces;
  Vec3 normals{}, center{};
  double area = 0;
  Box box;
  for (const Triangle& t : triangles) {
    const Vec3 normal = geometric_normal(t);
    const double twice = length(normal);
    normals += normal;
    center += (twice / 3) * (t.p0 + t.p1 + t.p2);
    area += twice;
    box.grow(bounds(t));
    faces.push_back({t.p0, t.p1, t.p2});
  }
  emitter.center = center / area;
  emitter.size = length(box.extent());
  if (length(normals) > 0.9999 * area) emitter.n = normalize(normals);

  emitter.light = make_mesh_light(faces, radiance);
  if (triangles.size() == 2) {
    const auto rectangle = parallelogram(triangles[0], triangles[1], radiance);
    if (rectangle) emitter.light = *rectangle;
  }
  return emitter;
}

Emitter sphere_emitter(const Sphere& sphere, Rgb radiance, const std::string& name) {
  const SphereLight light{sphere.center, sphere.radius, radiance};
  return {light, radiance, name, sphere.center, {}, 2 * sphere.radius};
}

}  // namespace pt
