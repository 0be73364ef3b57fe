#pragma once

#include "grader/pictures/statistics/sample_map_verdict.h"
#include "pt/image/film.h"
#include "pt/image/sample_map.h"

#include <cstdint>
#include <vector>

// Sample maps of adaptive renders, of the right rule and of known mistakes, without a renderer:
// each pixel draws its samples one at a time and stops by the rule.

namespace grader::pictures {

enum class StoppingRule {
  right,             // 1.96 sigma / sqrt(n) < tolerance mean, after each batch
  right_n,           // sigma divides by n, not n - 1
  running_total,     // each sample enters as the sum of all so far
  every_sample,      // checked after each sample
  sigma_over_n,      // sigma / n instead of sigma / sqrt(n)
  no_1_96,           // without the factor 1.96
  absolute,          // tolerance without the mean
  one_batch_short,   // the last batch is not counted
  one_channel,       // judges by one channel, which is a little noisier
  constant_goes_on,  // rounding keeps constant pixels going
};

// The exponential distribution of a pixel's samples: mean 1 and this deviation.
struct AdaptiveScene {
  int width = 0;
  int height = 0;
  std::vector<double> deviation;  // 0: constant
  std::vector<char> black;        // all samples 0
};

// Deviations from zero to more than the settings can reach, with a constant and a black strip.
AdaptiveScene adaptive_scene(int width, int height);

struct AdaptiveRun {
  pt::SampleMap map;
  pt::Image picture;
};

// `variance`: a sample's variance relative to the right one, for another method.
AdaptiveRun run_adaptive(const AdaptiveScene& scene, const pt::AdaptiveSettings& settings,
                         StoppingRule rule, double variance, std::uint64_t seed);

// The reference: 64 runs of the right rule.
SampleMapReference synthetic_reference(const AdaptiveScene& scene,
                                       const pt::AdaptiveSettings& settings);

}  // namespace grader::pictures
