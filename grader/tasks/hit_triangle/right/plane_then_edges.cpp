// right: first the plane, then the side of each edge, as areas
#include "pt/tasks/hit_triangle.h"

#include <cmath>
#include <utility>

namespace pt {

std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  const auto& [p0, p1, p2, n0, n1, n2] = triangle;
  const Vec3 n = cross(p1 - p0, p2 - p0);
  const double t = dot(p0 - ray.origin, n) / dot(ray.direction, n);
  if (!(t >= ray.t_min && t <= ray.t_max)) return std::nullopt;
  const Vec3 p = ray.at(t);
  const double b0 = dot(cross(p2 - p1, p - p1), n);
  const double b1 = dot(cross(p0 - p2, p - p2), n);
  const double b2 = dot(cross(p1 - p0, p - p0), n);
  if (!(b0 >= 0 && b1 >= 0 && b2 >= 0)) return std::nullopt;
  return SurfaceHit{t, normalize(b0 * n0 + b1 * n1 + b2 * n2)};
}

}  // namespace pt
