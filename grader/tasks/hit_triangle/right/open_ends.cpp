// right: exactly at an end of the range it misses
#include "pt/tasks/hit_triangle.h"

namespace pt {

std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  const Vec3 e1 = triangle.p1 - triangle.p0;
  const Vec3 e2 = triangle.p2 - triangle.p0;
  const Vec3 h = cross(ray.direction, e2);
  const double det = dot(e1, h);
  const Vec3 s = ray.origin - triangle.p0;
  const double b1 = dot(s, h) / det;
  const Vec3 q = cross(s, e1);
  const double b2 = dot(ray.direction, q) / det;
  if (!(b1 >= 0 && b2 >= 0 && b1 + b2 <= 1)) return std::nullopt;
  const double t = dot(e2, q) / det;
  if (!(t > ray.t_min && t < ray.t_max)) return std::nullopt;
  const Vec3 n = (1 - b1 - b2) * triangle.n0 + b1 * triangle.n1 + b2 * triangle.n2;
  return SurfaceHit{t, normalize(n)};
}

}  // namespace pt
