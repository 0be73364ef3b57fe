#include "pt/tasks/hit_triangle.h"

#include <algorithm>
#include <cmath>
namespace pt {
std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  const Vec3 e1 = triangle.p1 - triangle.p0, e2 = triangle.p2 - triangle.p0;
  const Vec3 p = cross(ray.direction, e2);
  const double det = dot(e1, p);
  if (det == 0) return std::nullopt;
  const Vec3 s = ray.origin - triangle.p0, q = cross(s, e1);
  const double b1 = dot(s, p) / det, b2 = dot(ray.direction, q) / det, t = dot(e2, q) / det;
  const double b0 = 1 - b1 - b2;
  if (!(b0 >= -1e-6 && b1 >= -1e-6 && b2 >= -1e-6)) return std::nullopt;
  if (!(t >= ray.t_min && t <= ray.t_max)) return std::nullopt;
  Vec3 n = b0 * triangle.n0 + b1 * triangle.n1 + b2 * triangle.n2;
  n = normalize(n);
  return SurfaceHit{t, n};
}
}  // namespace pt
