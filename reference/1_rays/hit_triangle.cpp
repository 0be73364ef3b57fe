#include "pt/tasks/hit_triangle.h"

namespace pt {

namespace {

// Returns whether the triple product of three vectors is larger than its rounding error. Without
// this test, a ray in the triangle's plane, or a triangle that is only a line, would give the
// quotient of two rounding errors, which can be any t. The error is at most about ten rounding
// errors of the product of the three lengths (Higham 2002, Accuracy and Stability of Numerical
// Algorithms, 3.1).
bool exceeds_rounding(double product, Vec3 a, Vec3 b, Vec3 c) {
  constexpr double kRounding = 16 * 0x1p-53;
  return product * product >
         kRounding * kRounding * length_squared(a) * length_squared(b) * length_squared(c);
}

}  // namespace

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

  // A small triangle has a tiny determinant and must still be hit, so no fixed epsilon is compared
  // with it. If the determinant is zero, the numbers below are infinite or NaN, and one of the
  // conditions is false.
  const double determinant = dot(e1, direction_x_e2);
  const double inverse_determinant = 1 / determinant;
  const double b1 = dot(s, direction_x_e2) * inverse_determinant;
  const double b2 = dot(ray.direction, s_x_e1) * inverse_determinant;
  const double b0 = 1 - b1 - b2;
  if (!(b0 >= 0 && b1 >= 0 && b2 >= 0)) return std::nullopt;

  const double t = dot(e2, s_x_e1) * inverse_determinant;
  if (!(t >= ray.t_min && t <= ray.t_max && t < kInfinity)) return std::nullopt;

  if (!exceeds_rounding(determinant, e1, e2, ray.direction)) return std::nullopt;
  return SurfaceHit{t, normalize(b0 * triangle.n0 + b1 * triangle.n1 + b2 * triangle.n2)};
}

}  // namespace pt
