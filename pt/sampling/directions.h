#pragma once

#include "pt/math/vec3.h"

#include <cmath>

// Maps from two uniform numbers to directions. Each says its density per steradian.

namespace pt {

// A unit direction in the local frame with z >= 0, uniform: density 1 / (2 pi). Equal heights cut
// equal areas from a sphere (Archimedes), so z is uniform.
inline Vec3 uniform_hemisphere(Vec2 xi) {
  const double z = xi.x;
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  const double phi = 2 * kPi * xi.y;
  return {r * std::cos(phi), r * std::sin(phi), z};
}

// A unit direction in the local frame with z >= 0 and density z / pi: a uniform point of the unit
// disk, lifted to the hemisphere above it (Malley's method).
inline Vec3 cosine_hemisphere(Vec2 xi) {
  const double r = std::sqrt(xi.x);
  const double phi = 2 * kPi * xi.y;
  return {r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - xi.x)};
}

// A unit direction around the z axis with z >= cos_max, uniform: density 1 / (2 pi
// one_minus_cos_max). The argument is 1 - cos_max, because computing this difference loses its
// digits if the cone is narrow.
inline Vec3 uniform_cone(Vec2 xi, double one_minus_cos_max) {
  const double h = xi.x * one_minus_cos_max;  // 1 - cos of the angle to z
  const double r = std::sqrt(std::max(0.0, h * (2 - h)));
  const double phi = 2 * kPi * xi.y;
  return {r * std::cos(phi), r * std::sin(phi), 1 - h};
}

}  // namespace pt
