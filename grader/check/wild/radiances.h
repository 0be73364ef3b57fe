#pragma once

#include "grader/check/generators/random_numbers.h"
#include "pt/math/rgb.h"

#include <string>
#include <vector>

namespace grader::check {

// Radiances of one pixel, of very different sizes.
struct WildRadiances {
  enum class Kind { constant, uniform, two_values, rarely_lit, exponential, spikes };
  Kind kind = Kind::constant;
  double share = 0;   // of the second value
  double bright = 1;  // how many times the first one it is
  pt::Rgb base;
  std::uint64_t seed = 0;

  std::vector<pt::Rgb> values(int n) const;
  std::string text() const;
};

WildRadiances wild_radiances(RandomNumbers& random);

// The same with few values that are far brighter than the others: what leaves them out, or makes them
// less, changes the mean.
WildRadiances rarely_bright(RandomNumbers& random);

}  // namespace grader::check
