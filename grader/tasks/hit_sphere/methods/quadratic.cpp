// method: the quadratic formula, as in textbooks
#include "pt/tasks/hit_sphere.h"

#include <cmath>

#ifndef REAL
#define REAL double
#endif

namespace pt {

namespace {

struct V {
  REAL x, y, z;
};

V to_v(Vec3 v) { return {static_cast<REAL>(v.x), static_cast<REAL>(v.y), static_cast<REAL>(v.z)}; }
V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
REAL dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  const V d = to_v(ray.direction), from_center = to_v(ray.origin) - to_v(sphere.center);
  const REAL radius = static_cast<REAL>(sphere.radius);
  const REAL a = dot(d, d), b = 2 * dot(from_center, d);
  const REAL c = dot(from_center, from_center) - radius * radius;
  const REAL discriminant = b * b - 4 * a * c;
  if (!(discriminant >= 0)) return std::nullopt;
  for (const REAL sign : {REAL{-1}, REAL{1}}) {
    const double t = (-b + sign * std::sqrt(discriminant)) / (2 * a);
    if (t >= ray.t_min && t <= ray.t_max) {
      return SurfaceHit{t, normalize(ray.at(t) - sphere.center)};
    }
  }
  return std::nullopt;
}

}  // namespace pt
