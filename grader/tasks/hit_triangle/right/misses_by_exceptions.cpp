// right: whatever misses is thrown, and caught at the end; the volumes of ray and edges in long
// double.
#include "pt/tasks/hit_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pt {

namespace {

using Real = long double;
using Vector = std::array<Real, 3>;

struct Miss {};
struct NoArea : Miss {};
struct BesideTheTriangle : Miss {};
struct OutsideTheRange : Miss {};

Vector difference(Vec3 a, Vec3 b) {
  return {static_cast<Real>(a.x) - b.x, static_cast<Real>(a.y) - b.y, static_cast<Real>(a.z) - b.z};
}
Real product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector moved(Vector a, Real t, const Vector& d) {
  for (int i = 0; i < 3; ++i) a[i] -= t * d[i];
  return a;
}
Real volume(const Vector& d, const Vector& a, const Vector& b) {
  return d[0] * (a[1] * b[2] - a[2] * b[1]) + d[1] * (a[2] * b[0] - a[0] * b[2]) +
         d[2] * (a[0] * b[1] - a[1] * b[0]);
}

// The ray winds around all edges in the same sense.
std::array<Real, 3> weights(const Vector& d, const std::array<Vector, 3>& corners, Real smallest) {
  const auto& [a, b, c] = corners;
  std::array<Real, 3> all{volume(d, b, c), volume(d, c, a), volume(d, a, b)};
  const Real sum = all[0] + all[1] + all[2];
  if (!(std::abs(sum) > smallest)) throw NoArea();
  for (Real& weight : all) {
    weight /= sum;
    if (weight < 0) throw BesideTheTriangle();
  }
  return all;
}

double in_range(Real t, const Ray& ray) {
  const double rounded = static_cast<double>(t);
  if (rounded < ray.t_min || rounded > ray.t_max) throw OutsideTheRange();
  return rounded;
}

SurfaceHit certain_hit(const Triangle& triangle, const Ray& ray) {
  const auto& [p0, p1, p2, n0, n1, n2] = triangle;
  const Vector d = difference(ray.direction, {});
  const Real speed = product(d, d);
  // The origin moves along the ray to where it is next to a corner.
  const Real start = product(difference(p0, ray.origin), d) / speed;
  std::array<Vector, 3> corners{difference(p0, ray.origin), difference(p1, ray.origin),
                                difference(p2, ray.origin)};
  for (Vector& corner : corners) corner = moved(corner, start, d);
  const Vector e1 = difference(p1, p0), e2 = difference(p2, p0);
  const Real size = std::sqrt(speed * product(e1, e1) * product(e2, e2));
  const auto [b0, b1, b2] = weights(d, corners, 1e-15L * size);

  Real t = start;
  for (int i = 0; i < 3; ++i) {
    t += (b0 * corners[0][i] + b1 * corners[1][i] + b2 * corners[2][i]) * d[i] / speed;
  }
  const Vec3 n =
      static_cast<double>(b0) * n0 + static_cast<double>(b1) * n1 + static_cast<double>(b2) * n2;
  return {in_range(t, ray), normalize(n)};
}

}  // namespace

std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  try {
    return certain_hit(triangle, ray);
  } catch (const Miss&) {
    return std::nullopt;
  }
}

}  // namespace pt
