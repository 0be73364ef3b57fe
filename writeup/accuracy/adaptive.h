#pragma once

#include "pt/tasks/adaptive_pixel.h"
#include "writeup/accuracy/study.h"

#include <vector>

namespace writeup::accuracy {

// The tolerance with which adaptive sampling has the relative variance `error2`, where each pixel is
// so noisy. The tolerance of `settings` is not looked at.
double tolerance_for(const std::vector<Study::PixelNoise>& noise, pt::AdaptiveSettings settings,
                     double error2);

}  // namespace writeup::accuracy
