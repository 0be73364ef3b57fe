// right: the normal mixed and normalised in single precision, the rest in double
#include "pt/tasks/hit_triangle.h"

#include <array>
#include <cmath>

namespace pt {

std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  const Vec3 e1 = triangle.p1 - triangle.p0, e2 = triangle.p2 - triangle.p0;
  const Vec3 s = ray.origin - triangle.p0;
  const Vec3 s1 = cross(ray.direction, e2), s2 = cross(s, e1);
  const double determinant = dot(s1, e1);
  if (determinant == 0) return {};
  const double t = dot(s2, e2) / determinant;
  const double b1 = dot(s1, s) / determinant, b2 = dot(s2, ray.direction) / determinant;
  if (t < ray.t_min || t > ray.t_max || b1 < 0 || b2 < 0 || b1 + b2 > 1) return {};

  std::array<float, 3> n{};
  float squares = 0;
  for (int i = 0; i < 3; ++i) {
    n[i] = static_cast<float>((1 - b1 - b2) * triangle.n0[i] + b1 * triangle.n1[i] +
                              b2 * triangle.n2[i]);
    squares += n[i] * n[i];
  }
  const float length = std::sqrt(squares);
  return SurfaceHit{t, {n[0] / length, n[1] / length, n[2] / length}};
}

}  // namespace pt
