#pragma once

#include "grader/check/language/fail.h"
#include "grader/check/language/property.h"
#include "grader/check/language/repeat.h"
#include "grader/tasks/trace_path/inputs.h"
#include "grader/tasks/trace_path/wild.h"
#include "pt/tasks/trace_path.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

// Estimates of the light along paths, and the noise that they may have.

namespace grader::check::trace_path_inputs {

inline constexpr int kCalls = 3000;

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

inline void expect_right_mean(const Case& c, const std::vector<Rgb>& found, double mean_square) {
  const Mean got = mean_of(found);
  const int from = std::max(1, c.settings.from), to = c.settings.to;
  expect_mean("the mean", got, c.room.sum(from, to), allowed_noise(c),
              c.room.precision(from, to) + error_by_chance(c, got, mean_square));
}

// Says of a wrong sum of bounces how wrong each of them is alone. Empty if there is one only, or so many that each gets few calls.
inline std::string each_bounce_alone(Case c, int calls) {
  constexpr int kMostBounces = 4;
  const int from = std::max(1, c.settings.from), to = c.settings.to;
  if (to <= from || to - from >= kMostBounces) return "";
  std::string said;
  for (int k = from; k <= to; ++k) {
    c.settings.from = c.settings.to = k;
    try {
      const Rgb got = mean_of(estimates(c, calls / (to - from + 1))).value;
      said += fmt::format("{} bounce {} is {:.2f} times", said.empty() ? "; alone," : ",", k,
                          max_channel(got) / max_channel(c.room.sum(k, k)));
    } catch (const CaseFailed&) {
      return "";  // a crash, for example
    }
  }
  return said + " the expected value";
}

inline void expect_mean_of(const Case& c, const std::vector<Rgb>& found, double mean_square = 1) {
  try {
    expect_right_mean(c, found, mean_square);
  } catch (CaseFailed& failed) {
    std::string& off = failed.failure.off_by;
    if (!off.empty()) off += each_bounce_alone(c, static_cast<int>(found.size()));
    throw;
  }
}

inline void expect_estimate(const Case& c, int calls = kCalls) {
  if (!needs_no_mean(c)) expect_mean_of(c, estimates(c, calls));
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

// Direct light that light sampling and hemisphere sampling find in different places.

inline bool needs_no_mean(const HalfLights& c, int light_samples) {
  PathSettings settings = c.settings;
  settings.light_samples = light_samples;
  return needs_no_mean(c.situation.scene, c.situation.point, settings, c.seed);
}

inline std::vector<Rgb> estimates(const HalfLights& c, int light_samples, int calls = kCalls) {
  PathSettings settings = c.settings;
  settings.light_samples = light_samples;
  return repeat<pt::trace_path>(calls, c.seed, c.situation.scene, c.situation.point, settings);
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
// the two measured noises. One sample has a large kurtosis, and needs more estimates; the mean of a
// hundred is almost normally distributed.
inline void expect_a_tenth_of_the_noise(const HalfLights& c) {
  constexpr int kMore = 16;
  constexpr double kKurtosisOfMany = 6;
  if (needs_no_mean(c, 1) && needs_no_mean(c, 100)) return;
  const Noise one = noise_of(estimates(c, 1, kMore * kCalls), 1);
  if (!(one.deviation.g > 0)) {
    fail_statistical("", "estimates that are all the same",
                     "estimates with one sample of direct light that vary");
  }
  const double ratio = noise_of(estimates(c, 100), 1).deviation.g / one.deviation.g;
  const double doubt =
      kStandardErrors * std::sqrt((one.kurtosis / kMore + kKurtosisOfMany) / (4 * kCalls));
  const double most = 0.1 * (1 + doubt);
  expect(ratio < most,
         fmt::format("100 samples of direct light with {:.2g} of the noise of one sample", most),
         fmt::format("{:.2g} of the noise", ratio));
}

// Pairs of estimates from one sampler.

inline double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const double n = static_cast<double>(a.size());
  const double mean_a = std::accumulate(a.begin(), a.end(), 0.0) / n;
  const double mean_b = std::accumulate(b.begin(), b.end(), 0.0) / n;
  double products = 0, squares_a = 0, squares_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    products += (a[i] - mean_a) * (b[i] - mean_b);
    squares_a += (a[i] - mean_a) * (a[i] - mean_a);
    squares_b += (b[i] - mean_b) * (b[i] - mean_b);
  }
  return products / std::sqrt(squares_a * squares_b);
}

// Fails the case if an estimate does not move the sampler, if two estimates in a row are not independent,
// or if an estimate of `before` changes the next one of `c`.
inline void expect_independent_pairs(const Case& c, const Case& before) {
  constexpr int kPairs = 300;
  const auto estimate = [](const Case& one, pt::Sampler& sampler) {
    return pt::trace_path(one.room.scene, one.room.point, one.settings, sampler);
  };
  std::vector<double> firsts, seconds;
  for (int i = 0; i < kPairs; ++i) {
    const pt::Sampler start = pt::Sampler::for_pixel(c.seed, i, 1);
    pt::Sampler sampler = start;
    const Rgb first = estimate(c, sampler);
    expect(sampler.state() != start.state(), "the sampler moved on", "as it was");
    const Rgb second = estimate(c, sampler);
    expect(first.g != second.g, "two estimates that differ, one after the other", "twice the same");
    if (i < 10) {
      pt::Sampler again = start;
      estimate(before, sampler);
      expect_near("the same estimate again", estimate(c, again), first, 0);
    }
    firsts.push_back(first.g);
    seconds.push_back(second.g);
  }
  const double found = correlation(firsts, seconds);
  expect(std::abs(found) < kStandardErrors / std::sqrt(kPairs), "two independent estimates",
         fmt::format("a correlation of {:.2g}", found));
}

// The bounces that paths reach.

// If a sixth of all paths reach a bounce, some of them reach the next one, for any survival. For
// example, a path goes on with a chance of .04 (roulette by the throughput, from bounce 2 on in a
// room of albedo .2). Then 24 of 600 paths go on, and the probability that none does is 4e-11.
inline constexpr int kPaths = 600, kEnough = 100;

// At least kEnough of kPaths paths reach the bounce `last`. Fewer reach the next one, `beyond`.
struct Reach {
  int last = 2, beyond = 0;
};

// Halves the range of bounces, beginning with the cap itself. `last` is the cap if many paths reach it.
inline Reach reach_of(const Case& c) {
  Reach reach{2, c.settings.to + 1};
  while (reach.beyond - reach.last > 1) {
    const int k = reach.beyond > c.settings.to ? c.settings.to : (reach.last + reach.beyond) / 2;
    (lit(c, k, kPaths) >= kEnough ? reach.last : reach.beyond) = k;
  }
  return reach;
}

}  // namespace grader::check::trace_path_inputs
