#pragma once

#include "measure/scene/study.h"
#include "pt/tasks/adaptive_pixel.h"

#include <vector>

namespace measure::scene {

// The tolerance with which adaptive sampling has the relative variance `error2`, given the noise of
// each pixel. The tolerance of `settings` is ignored.
double tolerance_for(const std::vector<Study::PixelNoise>& noise, pt::AdaptiveSettings settings,
                     double error2);

}  // namespace measure::scene
