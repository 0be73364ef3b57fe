#include "pt/tasks/hit_triangle.h"

namespace pt {

// Moeller and Trumbore 1997, Fast, Minimum Storage Ray/Triangle Intersection. The unknowns t, b1
// and b2 of
//     origin + t direction = p0 + b1 (p1 - p0) + b2 (p2 - p0)
// are quotients of determinants (Cramer's rule), and each determinant is a triple product.
std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  const Vec3 e1 = triangle.p1 - triangle.p0;
  const Vec3 e2 = triangle.p2 - triangle.p0;
  const Vec3 s = ray.origin - triangle.p0;
  const Vec3 direction_x_e2 = cross(ray.direction, e2);
  const Vec3 s_x_e1 = cross(s, e1);

  // Zero in the triangle's plane and for triangles without area: then what follows is infinite or
  // NaN, and no comparison with "accept if" below is true. A small triangle at a small scale has a
  // tiny determinant too, and must be hit: there is no epsilon here.
  const double inverse_determinant = 1 / dot(e1, direction_x_e2);
  const double b1 = dot(s, direction_x_e2) * inverse_determinant;
  const double b2 = dot(ray.direction, s_x_e1) * inverse_determinant;
  const double b0 = 1 - b1 - b2;
  if (!(b0 >= 0 && b1 >= 0 && b2 >= 0)) return std::nullopt;

  const double t = dot(e2, s_x_e1) * inverse_determinant;
  if (!(t >= ray.t_min && t <= ray.t_max && t < kInfinity)) return std::nullopt;

  return SurfaceHit{t, normalize(b0 * triangle.n0 + b1 * triangle.n1 + b2 * triangle.n2)};
}

}  // namespace pt
