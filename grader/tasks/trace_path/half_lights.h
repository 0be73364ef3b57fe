#pragma once

#include "grader/tasks/trace_path/estimates.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>

// Direct light that light sampling and hemisphere sampling find in different places.

namespace grader::check::trace_path_inputs {

inline std::vector<Rgb> estimates(const HalfLights& c, int light_samples) {
  PathSettings settings = c.settings;
  settings.light_samples = light_samples;
  return repeat<pt::trace_path>(kCalls, c.seed, c.situation.scene, c.situation.point, settings);
}

// At the squared distance r, a point of the left light contributes in proportion to 1 / r^2, where
// r is 1.25 to 3.5. The deviation is at most half of the range of these values. A direction rarely
// meets the right light. The solid angle of this light is more than 0.25, so the deviation of one
// direction is at most the mean times the root of 2 pi / 0.25.
inline Noise noise_of_half_lights(const HalfLights& c) {
  const Rgb mean = c.expected;
  const Rgb one = c.settings.direct == Direct::lights
                      ? mean * (0.5 * (3.5 * 3.5 / (1.25 * 1.25) - 1))
                      : mean * std::sqrt(2 * pt::kPi / 0.25);
  return {2 * one / std::sqrt(c.settings.light_samples)};
}

// A hundred samples have a tenth of the noise of one sample. `doubt` is the statistical error of
// the two measured noises.
inline void expect_a_tenth_of_the_noise(const HalfLights& c) {
  const Noise one = noise_of(estimates(c, 1), 1), many = noise_of(estimates(c, 100), 1);
  expect(one.deviation.g > 0, "estimates with one sample of direct light that vary",
         fmt::format("a standard deviation of {:.3g}", one.deviation.g));
  const double ratio = many.deviation.g / one.deviation.g;
  const double doubt = kStandardErrors * std::sqrt((one.kurtosis + many.kurtosis) / (4 * kCalls));
  const double most = 0.1 * (1 + doubt);
  expect(ratio < most,
         fmt::format("100 samples of direct light with {:.2g} of the noise of one sample", most),
         fmt::format("{:.2g} of the noise", ratio));
}

}  // namespace grader::check::trace_path_inputs
