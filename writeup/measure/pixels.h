#pragma once

#include "pt/render/radiance.h"
#include "pt/scene/view.h"
#include "writeup/measure/estimates.h"

#include <vector>

namespace writeup::measure {

struct Pixel {
  int x = 0, y = 0;
  double truth = 0;  // its mean
};

// A picture of two colors; in case 1 they are noisy.
pt::View view_of_pixels(int of_case);
std::vector<Pixel> pixels();

}  // namespace writeup::measure
