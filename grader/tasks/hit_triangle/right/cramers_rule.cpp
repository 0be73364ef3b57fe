// right: the linear equations solved by Cramer's rule
#include "pt/tasks/hit_triangle.h"

#include <cmath>
#include <utility>

namespace pt {

std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  // p0 + b1 e1 + b2 e2 - t d = origin, by columns.
  const auto determinant = [](Vec3 a, Vec3 b, Vec3 c) { return dot(cross(a, b), c); };
  const Vec3 e1 = triangle.p1 - triangle.p0;
  const Vec3 e2 = triangle.p2 - triangle.p0;
  const Vec3 d = -ray.direction;
  const Vec3 s = ray.origin - triangle.p0;
  const double all = determinant(e1, e2, d);
  if (all == 0) return std::nullopt;
  const double b1 = determinant(s, e2, d) / all;
  const double b2 = determinant(e1, s, d) / all;
  const double t = determinant(e1, e2, s) / all;
  const double b0 = 1 - b1 - b2;
  if (b0 < 0 || b1 < 0 || b2 < 0 || t < ray.t_min || t > ray.t_max) return std::nullopt;
  return SurfaceHit{t, normalize(b0 * triangle.n0 + b1 * triangle.n1 + b2 * triangle.n2)};
}

}  // namespace pt
