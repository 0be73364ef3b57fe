#pragma once

#include "pt/math/vec3.h"
#include "pt/sampling/sampler.h"

#include <cmath>

// Random numbers for inputs.

namespace measure::calls {

inline double between(double low, double high, pt::Sampler& sampler) {
  return low + (high - low) * sampler.next_1d();
}

// From 10^low to 10^high, with a uniform logarithm.
inline double size_between(double low, double high, pt::Sampler& sampler) {
  return std::pow(10, between(low, high, sampler));
}

inline pt::Vec3 in_cube(double half, pt::Sampler& sampler) {
  const double x = between(-half, half, sampler), y = between(-half, half, sampler);
  return {x, y, between(-half, half, sampler)};
}

// A direction of unit length, uniform over the sphere.
inline pt::Vec3 any_direction(pt::Sampler& sampler) {
  const double z = between(-1, 1, sampler), angle = between(0, 2 * pt::kPi, sampler);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

}  // namespace measure::calls
