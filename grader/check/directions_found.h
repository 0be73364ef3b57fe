#pragma once

#include "pt/math/vec3.h"

#include <string>
#include <vector>

// Where the directions go that a sampler chooses, against where they should go.

namespace grader::check {

// A cell of the hemisphere: a direction in the middle of it, in local coordinates (z along the
// normal), how many directions went there and how many should on average.
struct DirectionCell {
  pt::Vec3 middle;
  double found = 0;
  double expected = 0;
};

// Makes the case fail if the directions are not spread as expected, by a chi-square test that fails
// right ones 1e-9 of the time. It says where most of them are missing or too many, as in
// "0 directions within 20 degrees of the normal".
void expect_spread(const std::vector<DirectionCell>& cells);

}  // namespace grader::check
