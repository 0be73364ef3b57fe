#pragma once

#include "grader/check/language/property.h"
#include "grader/check/language/repeat.h"
#include "grader/tasks/trace_path/inputs.h"
#include "pt/tasks/trace_path.h"

#include <algorithm>
#include <cmath>
#include <vector>

// Estimates of the light along paths, and the noise that they may have.

namespace grader::check::trace_path_inputs {

inline constexpr int kCalls = 4000;

inline std::vector<Rgb> estimates(const Case& c, int calls) {
  return repeat<pt::trace_path>(calls, c.seed, c.room.scene, c.room.point, c.settings);
}

// The largest noise that the contract allows: twice the noise with a survival of .3 or less, and
// with inner tasks that are as noisy as their contracts allow.
inline Noise allowed_noise(const Case& c) {
  return {2 * deviation(c.room, c.settings, {std::min(0.3, c.settings.survival), 2, 2})};
}

// If only few paths find light, their spread does not show the error of their mean. So at least the
// error of the usual method is allowed. `mean_square` is that of its diffuse_sample
// (grader/check/scenes/rooms.h).
inline double error_by_chance(const Case& c, const Mean& got, double mean_square) {
  const Rgb usual = deviation(c.room, c.settings, {c.settings.survival, mean_square});
  double more = 0;
  for (int channel = 0; channel < 3; ++channel) {
    more = std::max(more, usual[channel] / std::sqrt(got.n) - got.standard_error[channel]);
  }
  return kStandardErrors * more;
}

inline void expect_mean_of(const Case& c, const std::vector<Rgb>& found, double mean_square = 1) {
  const Mean got = mean_of(found);
  const int from = std::max(1, c.settings.from), to = c.settings.to;
  expect_mean("the mean", got, c.room.sum(from, to), allowed_noise(c),
              c.room.precision(from, to) + error_by_chance(c, got, mean_square));
}

inline void expect_estimate(const Case& c, int calls = kCalls) {
  expect_mean_of(c, estimates(c, calls));
}

// Returns how many estimates are not black.
inline int lit_among(const std::vector<Rgb>& all) {
  return static_cast<int>(
      std::count_if(all.begin(), all.end(), [](const Rgb& one) { return max_channel(one) > 0; }));
}

// The same of `calls` estimates of bounce k alone.
inline int lit(Case c, int k, int calls) {
  c.settings.from = c.settings.to = k;
  return lit_among(estimates(c, calls));
}

// Returns the mean square of the estimates of bounce k alone.
inline double mean_square(Case c, int k, int calls) {
  c.settings.from = c.settings.to = k;
  double sum = 0;
  for (const Rgb& one : estimates(c, calls)) sum += one.g * one.g;
  return sum / calls;
}

// Returns what the variance of bounce `to` alone will be, as a multiple of its squared mean, in a
// furnace of `albedo`. Each bounce multiplies the estimate by a weight f cos / pdf of the
// solution's own diffuse_sample. The weights of different bounces are independent, so each bounce
// multiplies the mean square by the same factor: albedo^2 for directions in proportion to the
// cosine, 4/3 albedo^2 for uniform ones. Then bounce 30 would need millions of estimates, because
// few of them have nearly all the light. The factor is found from bounces 2 and 6 of paths of which
// few end.
inline double relative_variance_far_along(Case c) {
  constexpr int kNear = 2, kBeyond = 6;
  c.settings.survival = 0.998;
  const double albedo = c.room.point.albedo.g;
  const double grown = mean_square(c, kBeyond, kCalls) / mean_square(c, kNear, kCalls);
  const double each = std::pow(grown, 1.0 / (kBeyond - kNear)) / (albedo * albedo);
  return std::pow(each, c.settings.to) - 1;
}

}  // namespace grader::check::trace_path_inputs
