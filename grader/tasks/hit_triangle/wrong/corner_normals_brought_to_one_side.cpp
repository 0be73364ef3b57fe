// breaks: interpolates_the_corner_normals
// Turns corner normals around that are more than a right angle from the first one.
#include "pt/tasks/hit_triangle.h"

namespace pt {

std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  const Vec3 e1 = triangle.p1 - triangle.p0, e2 = triangle.p2 - triangle.p0;
  const Vec3 h = cross(ray.direction, e2);
  const double det = dot(e1, h);
  if (det == 0) return std::nullopt;
  const Vec3 s = ray.origin - triangle.p0, q = cross(s, e1);
  const double b1 = dot(s, h) / det, b2 = dot(ray.direction, q) / det;
  const double b0 = 1 - b1 - b2;
  if (!(b0 >= 0 && b1 >= 0 && b2 >= 0)) return std::nullopt;
  const double t = dot(e2, q) / det;
  if (!(t >= ray.t_min && t <= ray.t_max)) return std::nullopt;
  const auto brought = [&](Vec3 n) { return dot(n, triangle.n0) < -0.35 ? -n : n; };
  const Vec3 n1 = brought(triangle.n1), n2 = brought(triangle.n2);
  return SurfaceHit{t, normalize(b0 * triangle.n0 + b1 * n1 + b2 * n2)};
}

}  // namespace pt
