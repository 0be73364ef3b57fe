#include "grader/stand_ins/counting.h"
#include "pt/tasks/hit_triangle.h"

namespace pt {

// First the plane, then on which side of each edge the point lies.
std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  grader::count(triangle);
  const Vec3 n = geometric_normal(triangle);
  const double t = dot(triangle.p0 - ray.origin, n) / dot(ray.direction, n);
  if (!(t >= ray.t_min && t <= ray.t_max)) return std::nullopt;
  const Vec3 p = ray.at(t);
  const double b0 = dot(cross(triangle.p2 - triangle.p1, p - triangle.p1), n) / dot(n, n);
  const double b1 = dot(cross(triangle.p0 - triangle.p2, p - triangle.p2), n) / dot(n, n);
  const double b2 = dot(cross(triangle.p1 - triangle.p0, p - triangle.p0), n) / dot(n, n);
  if (!(b0 >= 0 && b1 >= 0 && b2 >= 0)) return std::nullopt;
  return SurfaceHit{t, normalize(b0 * triangle.n0 + b1 * triangle.n1 + b2 * triangle.n2)};
}

}  // namespace pt
