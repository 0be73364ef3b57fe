#include "pt/tasks/hit_triangle.h"

#include <array>
namespace pt {
namespace {
using Matrix = std::array<Vec3, 3>;  // columns
double det(const Matrix& m) { return dot(m[0], cross(m[1], m[2])); }
}  // namespace
// Cramer's rule on the 3 x 3 system, one determinant for each unknown.
std::optional<SurfaceHit> hit_triangle(const Triangle& tri, const Ray& ray) {
  Matrix m{tri.p1 - tri.p0, tri.p2 - tri.p0, -ray.direction};
  Vec3 rhs = ray.origin - tri.p0;
  double d = det(m);
  double size = length(m[0]) * length(m[1]) * length(m[2]);
  if (!(std::abs(d) > 1e-14 * size)) return std::nullopt;
  std::array<double, 3> x;
  for (int i = 0; i < 3; ++i) {
    Matrix c = m;
    c[i] = rhs;
    x[i] = det(c) / d;
  }
  auto [u, v, t] = x;
  bool inside = u >= 0 && v >= 0 && u + v <= 1;
  if (!inside || !(ray.t_min <= t && t <= ray.t_max)) return std::nullopt;
  return SurfaceHit{.t = t, .n = normalize(tri.n0 + u * (tri.n1 - tri.n0) + v * (tri.n2 - tri.n0))};
}
}  // namespace pt
