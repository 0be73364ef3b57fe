#pragma once

#include "measure/scene/study.h"
#include "pt/tasks/adaptive_pixel.h"

#include <vector>

namespace measure::scene {

// The tolerance with which adaptive sampling has the relative variance `error2`, given the noise of
// each pixel. The tolerance of `settings` is ignored.
double tolerance_for(const std::vector<Study::PixelNoise>& noise, pt::AdaptiveSettings settings,
                     double error2);

// The samples of each pixel by the rule of adaptive_pixel, if it knew the noise: v / g^2 times
// (1.96 / tolerance)^2, in whole batches.
std::vector<double> adaptive_samples(const std::vector<Study::PixelNoise>& noise,
                                     const pt::AdaptiveSettings& settings);

// relMSE of a picture with so many samples in each pixel, without a bias.
double relmse_with(const std::vector<Study::PixelNoise>& noise, const std::vector<double>& samples);

// The samples that the best numbers of samples need for a relMSE, over those of the same number in
// every pixel. They are in proportion to sigma / (g + d), where the contract has the square.
double best_possible(const std::vector<Study::PixelNoise>& noise);

}  // namespace measure::scene
