#pragma once

#include "pt/math/vec3.h"

#include <cmath>

namespace pt {

// Converts between a whole angle in degrees and half the width that it spans at distance 1.
inline double half_tangent(double fov_deg) { return std::tan(0.5 * fov_deg * (kPi / 180)); }
inline double fov_from(double half_tangent) { return 2 * std::atan(half_tangent) * (180 / kPi); }

}  // namespace pt
