#include "pt/scene/collada/place.h"

#include <cmath>

namespace pt {

std::optional<Triangle> place(const FileTriangle& triangle, const Transform& to_world) {
  const bool mirrors = to_world.determinant() < 0;
  const int order[3] = {0, mirrors ? 2 : 1, mirrors ? 1 : 2};
  Triangle placed;
  placed.p0 = to_world.point(triangle.p[order[0]]);
  placed.p1 = to_world.point(triangle.p[order[1]]);
  placed.p2 = to_world.point(triangle.p[order[2]]);
  const Vec3 geometric = geometric_normal(placed);
  if (!std::isnormal(length_squared(geometric))) return std::nullopt;
  const Vec3 face = normalize(geometric);
  const auto unit_normal = [&](int corner) {
    // Two steps, so that neither tiny normals nor tiny scales underflow.
    const Vec3 local = triangle.n[order[corner]];
    if (!std::isnormal(length_squared(local))) return face;
    const Vec3 n = to_world.normal(normalize(local));
    if (!std::isnormal(length_squared(n))) return face;
    return mirrors ? -normalize(n) : normalize(n);
  };
  placed.n0 = unit_normal(0);
  placed.n1 = unit_normal(1);
  placed.n2 = unit_normal(2);
  return placed;
}

std::optional<Sphere> place_sphere(double radius, const Transform& to_world) {
  constexpr double kTolerance = 1e-5;
  const Vec3 axes[3] = {to_world.x, to_world.y, to_world.z};
  const double scale = std::cbrt(std::abs(to_world.determinant()));
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(length(axes[i]) - scale) <= kTolerance * scale)) return std::nullopt;
    if (!(std::abs(dot(axes[i], axes[(i + 1) % 3])) <= kTolerance * scale * scale)) {
      return std::nullopt;
    }
  }
  if (!std::isnormal(scale * radius)) return std::nullopt;
  return Sphere{to_world.translation, scale * radius};
}

}  // namespace pt
