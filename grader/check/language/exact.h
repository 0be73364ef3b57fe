#pragma once

#include "pt/math/vec3.h"

#include <cmath>

// Arithmetic of 113 bits, if the compiler has it: an oracle for tasks that compute in double.

namespace grader::check {

#ifdef __SIZEOF_FLOAT128__
__extension__ using Exact = __float128;
#else
using Exact = long double;  // of 113 bits on ARM
#endif

struct Exact3 {
  Exact x = 0, y = 0, z = 0;

  Exact3() = default;
  Exact3(Exact a, Exact b, Exact c) : x(a), y(b), z(c) {}
  Exact3(pt::Vec3 v) : x(v.x), y(v.y), z(v.z) {}  // NOLINT: every double is one
};

inline Exact3 operator+(Exact3 a, Exact3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Exact3 operator-(Exact3 a, Exact3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Exact3 operator*(Exact s, Exact3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline Exact dot(Exact3 a, Exact3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Exact3 cross(Exact3 a, Exact3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Rounds a small difference that was computed exactly.
inline double rounded(Exact a) { return static_cast<double>(a); }
inline pt::Vec3 rounded(Exact3 a) { return {rounded(a.x), rounded(a.y), rounded(a.z)}; }

// Roots have the precision of long double.
inline long double root(Exact a) { return std::sqrt(static_cast<long double>(a)); }
inline long double length(Exact3 a) { return root(dot(a, a)); }
inline Exact3 normalize(Exact3 a) { return 1 / Exact(length(a)) * a; }

}  // namespace grader::check
