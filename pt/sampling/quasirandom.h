#pragma once

#include "pt/math/vec3.h"

#include <cmath>

namespace pt {

// Point i of a sequence that fills the square [0, 1)^2 evenly, however many points of it are taken
// (Roberts 2018, The Unreasonable Effectiveness of Quasirandom Sequences). All points are moved by
// the vector `start`; a point that leaves the square on one side comes back on the other. With a
// start that is uniform in the square, so is each point (Cranley and Patterson 1976): a mean over
// the points has no bias.
inline Vec2 low_discrepancy_point(Vec2 start, int i) {
  // 1 / g and 1 / g^2, where g^3 = g + 1: the golden ratio of two dimensions.
  const double x = start.x + 0.7548776662466927 * i;
  const double y = start.y + 0.5698402909980532 * i;
  return {x - std::floor(x), y - std::floor(y)};
}

}  // namespace pt
