#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/language/property.h"
#include "grader/check/language/repeat.h"
#include "grader/check/scenes/scenes.h"
#include "grader/check/scenes/textbook.h"
#include "pt/tasks/direct_lights.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

// Estimates of direct light, and whether they are right.

namespace grader::check::direct_lights_inputs {

using pt::Rgb;

// The error that the contract allows in addition to noise: 1e-5 of the value for the task, the same
// for diffuse_f, which the task may call, and a millionth of each light for its cosine.
inline double tolerance(const Situation& s) {
  return 2 * kColorPrecision * max_channel(s.expected) +
         1e-6 * max_channel(s.point.albedo * s.facing) / pt::kPi;
}

inline std::vector<Rgb> estimates(const Situation& s, int calls, int samples) {
  return repeat<pt::direct_lights>(calls, draw("seed", sampler_seed()), s.scene, s.point, samples);
}

// The error from rare draws. A draw that adds about as much as the mean may be so rare that it does
// not occur in this many draws. The measured noise then does not contain it. In multiple importance
// sampling, BSDF samples that meet a small light are rare draws of this kind.
inline double missed(const Situation& s, int draws) {
  constexpr double kRare = 30;
  return kRare / draws * max_channel(s.expected);
}

// The more samples or lights per call, the fewer calls.
inline void expect_estimate(const Situation& s, int samples) {
  const int lights = std::max(1, static_cast<int>(s.scene.lights.size()));
  const int calls = std::clamp(32000 / samples / lights, 100, 4000);
  expect_mean(fmt::format("the mean, {} samples per call", samples),
              mean_of(estimates(s, calls, samples)), s.expected, noise_of_lights(s, samples),
              tolerance(s) + missed(s, calls * samples));
}

// Without randomness, every single estimate has to be right.
inline void expect_always(const Situation& s, int samples) {
  for (const Rgb& one : estimates(s, 8, samples)) {
    expect_near(fmt::format("each estimate, {} samples per call", samples), one, s.expected,
                tolerance(s));
  }
}

// The noise of many samples is compared with that of one sample, `of_one`, which is the submission's
// own. The noise of one sample has the same limit as everywhere. The variances of two sets of n
// draws differ by less than the part `doubt`.
inline void expect_less_noise(const Situation& s, const std::vector<Rgb>& of_one, int samples,
                              int calls) {
  const double doubt = 9.5 / std::sqrt(of_one.size());
  Noise most = noise_of(of_one, std::sqrt((1 + doubt) / samples));
  most.kurtosis = 3;
  expect_noise(fmt::format("the noise with {} samples per call, against that with 1, which is "
                           "{:.3g}",
                           samples, noise_of(of_one, 1).deviation.g),
               mean_of(estimates(s, calls, samples)), most);
}

}  // namespace grader::check::direct_lights_inputs
