// method: Moeller and Trumbore, without a limit for the determinant
#include "pt/tasks/hit_triangle.h"

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
V cross(V a, V b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

}  // namespace

std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  const V p0 = to_v(triangle.p0), d = to_v(ray.direction);
  const V e1 = to_v(triangle.p1) - p0, e2 = to_v(triangle.p2) - p0;
  const V h = cross(d, e2), s = to_v(ray.origin) - p0, q = cross(s, e1);
  const REAL determinant = dot(e1, h);
  const REAL b1 = dot(s, h) / determinant, b2 = dot(d, q) / determinant;
  if (!(b1 >= 0 && b2 >= 0 && b1 + b2 <= 1)) return std::nullopt;
  const double t = dot(e2, q) / determinant;
  if (!(t >= ray.t_min && t <= ray.t_max)) return std::nullopt;
  return SurfaceHit{t,
                    normalize((1 - b1 - b2) * triangle.n0 + b1 * triangle.n1 + b2 * triangle.n2)};
}

}  // namespace pt
