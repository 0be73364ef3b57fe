#pragma once

#include "measure/calls/estimates.h"
#include "pt/render/radiance.h"
#include "pt/scene/view.h"

#include <vector>

namespace measure::calls {

struct Pixel {
  int x = 0, y = 0;
  double truth = 0;  // its mean
};

// A picture of two colors; in case 1 they are noisy.
pt::View view_of_pixels(int of_case);
std::vector<Pixel> pixels();

}  // namespace measure::calls
