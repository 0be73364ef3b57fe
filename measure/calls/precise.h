#pragma once

#include "pt/math/vec3.h"

#include <algorithm>
#include <cmath>

// Vectors of long double, for comparison with answers in double.

namespace measure::calls {

struct Precise3 {
  long double x = 0, y = 0, z = 0;

  Precise3() = default;
  Precise3(long double a, long double b, long double c) : x(a), y(b), z(c) {}
  Precise3(pt::Vec3 v) : x(v.x), y(v.y), z(v.z) {}  // NOLINT: every double converts exactly

  long double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

inline Precise3 operator+(Precise3 a, Precise3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Precise3 operator-(Precise3 a, Precise3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Precise3 operator*(long double s, Precise3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline long double dot(Precise3 a, Precise3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Precise3 cross(Precise3 a, Precise3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline long double length(Precise3 a) { return std::sqrt(dot(a, a)); }
inline Precise3 normalize(Precise3 a) { return 1 / length(a) * a; }

// Never NaN: a result that is not a number counts as the largest error.
inline void keep_largest(double& largest, long double error) {
  const auto size = static_cast<double>(std::abs(error));
  largest = size >= 0 ? std::max(largest, size) : pt::kInfinity;
}

}  // namespace measure::calls
