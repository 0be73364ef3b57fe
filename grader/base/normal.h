#pragma once

#include <cassert>
#include <cmath>
#include <numbers>

namespace grader::base {

// The z that a standard normal number exceeds with this probability, in (0, 0.5]. It is found by
// bisection, because the standard library has only the probability.
inline double normal_quantile_above(double probability) {
  assert(probability > 0 && probability <= 0.5);
  double low = 0, high = 40;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (std::erfc(middle / std::numbers::sqrt2) / 2 > probability ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace grader::base
