#pragma once

#include "pt/math/vec3.h"

#include <string>
#include <vector>

// Compares the directions that a sampler chooses with the directions that it should choose.

namespace grader::check {

// A cell of the hemisphere. `middle` is the direction in its middle, in local coordinates (z along
// the normal). `found` is the number of directions in the cell, and `expected` the right mean
// number.
struct DirectionCell {
  pt::Vec3 middle;
  double found = 0;
  double expected = 0;
};

// Makes the case fail if the directions are not spread as expected. The chi-square test fails right
// directions with a probability of 1e-9. The failure names the region that is most wrong, for
// example "0 directions within 20 degrees of the normal". `source` says where the expected numbers come
// from, for example ", by your pdf".
void expect_spread(const std::vector<DirectionCell>& cells, const std::string& source = "");

}  // namespace grader::check
