#pragma once

#include "pt/math/rgb.h"

#include <algorithm>
#include <cmath>

// Arithmetic on colours channel by channel, for variances.

namespace grader::check {

inline pt::Rgb squared(pt::Rgb c) { return c * c; }

// The root of each channel. A negative channel, which only rounding makes, gives 0; NaN stays NaN.
inline pt::Rgb square_root(pt::Rgb c) {
  const auto root = [](double x) { return x < 0 ? 0 : std::sqrt(x); };
  return {root(c.r), root(c.g), root(c.b)};
}

inline pt::Rgb absolute(pt::Rgb c) { return {std::abs(c.r), std::abs(c.g), std::abs(c.b)}; }

inline pt::Rgb larger(pt::Rgb a, pt::Rgb b) {
  return {std::max(a.r, b.r), std::max(a.g, b.g), std::max(a.b, b.b)};
}

}  // namespace grader::check
