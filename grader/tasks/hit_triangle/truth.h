#pragma once

#include "grader/check/language/exact.h"
#include "pt/geometry/ray.h"
#include "pt/geometry/triangle.h"

#include <algorithm>

// Where the line of a ray meets the plane of a triangle: the oracle for triangles and rays of which nothing is known.

namespace grader::check::hit_triangle_inputs {

// A point of a triangle's plane, as weights of the corners. They sum to 1.
struct Place {
  Exact b0 = 0, b1 = 0, b2 = 0;

  double least() const { return std::min({rounded(b0), rounded(b1), rounded(b2)}); }
};

// The place of p; if p is beside the plane, the place of its projection.
inline Place place_of(const pt::Triangle& triangle, const Exact3& p) {
  const Exact3 p0 = triangle.p0, p1 = triangle.p1, p2 = triangle.p2;
  const Exact3 n = cross(p1 - p0, p2 - p0);
  const auto weight = [&](const Exact3& a, const Exact3& b) {
    return dot(cross(a - p, b - p), n) / dot(n, n);
  };
  return {weight(p1, p2), weight(p2, p0), weight(p0, p1)};
}

// The mean of the corner normals there.
inline Exact3 normal_at(const pt::Triangle& triangle, const Place& at) {
  return normalize(at.b0 * Exact3(triangle.n0) + at.b1 * Exact3(triangle.n1) +
                   at.b2 * Exact3(triangle.n2));
}

struct Meeting {
  Exact t = 0;
  Place at;
};

inline Meeting meet(const pt::Triangle& triangle, const pt::Ray& ray) {
  const Exact3 p0 = triangle.p0, origin = ray.origin, d = ray.direction;
  const Exact3 n = cross(Exact3(triangle.p1) - p0, Exact3(triangle.p2) - p0);
  const Exact t = dot(p0 - origin, n) / dot(d, n);
  return {t, place_of(triangle, origin + t * d)};
}

}  // namespace grader::check::hit_triangle_inputs
