// method: the discriminant from the distance between centre and ray, and no root by a difference
// (Haines, Guenther and Akenine-Moeller 2019)
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
V operator*(REAL s, V v) { return {s * v.x, s * v.y, s * v.z}; }
REAL dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  const V d = to_v(ray.direction), to_center = to_v(sphere.center) - to_v(ray.origin);
  const REAL radius = static_cast<REAL>(sphere.radius);
  const REAL a = dot(d, d), b = dot(to_center, d);
  const V beside = to_center - (b / a) * d;
  const REAL discriminant = a * (radius * radius - dot(beside, beside));
  if (!(discriminant >= 0)) return std::nullopt;
  const REAL q = b + std::copysign(std::sqrt(discriminant), b);
  const REAL c = dot(to_center, to_center) - radius * radius;
  for (const double t : {std::fmin(c / q, q / a), std::fmax(c / q, q / a)}) {
    if (t >= ray.t_min && t <= ray.t_max) {
      return SurfaceHit{t, normalize(ray.at(t) - sphere.center)};
    }
  }
  return std::nullopt;
}

}  // namespace pt
