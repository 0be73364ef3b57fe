#include "grader/check/language/fail.h"
#include "grader/check/language/property.h"
#include "grader/check/scenes/channels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

// Means of random draws: how far they may be off by chance, and how noisy the draws may be.

namespace grader::check {

using pt::Rgb;

namespace {

// Returns whether one draw is more than half of the sum. Then other draws would give another mean.
bool hangs_on_one_draw(const Mean& got, int channel) {
  return got.n > 2 && got.largest_share[channel] > 0.5;
}

// The limit for a measured standard deviation. If the true deviation is the largest right one, it
// is exceeded less than once in a million sets of n draws. The variance that is measured on n draws
// has a relative variance of about kurtosis / n.
double most_measured(const Noise& at_most, int channel, int n) {
  const double by_chance = kStandardErrors * std::sqrt(at_most.kurtosis / n);
  return at_most.deviation[channel] * std::sqrt(1 + by_chance);
}

[[noreturn]] void fail_mean(const std::string& what, const Mean& got, Rgb expected, double allowed,
                            int channel) {
  fail_statistical(what, fmt::format("{} as the mean of {} estimates", brief(got.value), got.n),
                   fmt::format("{}, give or take {:.2g}", brief(expected), allowed),
                   off_by(got.value[channel], expected[channel]));
}

// The first words of a failure because of noise. Even if the mean is close, so much noise hides
// whether it is right.
enum class Average { unknown, close, far };
std::string too_noisy(Average average) {
  switch (average) {
    case Average::close:
      return "too noisy, although the mean may be right";
    case Average::far:
      return "too noisy to judge the mean";
    default:
      return "too noisy";
  }
}

[[noreturn]] void fail_one_draw(const std::string& what, const Mean& got, int channel,
                                Average average) {
  fail_statistical(what,
                   fmt::format("{}: one of {} estimates is {:.0f} % of their sum",
                               too_noisy(average), got.n, 100 * got.largest_share[channel]),
                   "estimates of about the same size");
}

[[noreturn]] void fail_noise(const std::string& what, const Mean& got, double most, int channel,
                             Average average) {
  // A weight without a limit makes some estimates far larger than the rest.
  constexpr double kFarLarger = 0.03;
  const double largest = got.largest_share[channel];
  const std::string one =
      largest > kFarLarger && largest * got.n > 10
          ? fmt::format("; one of {} is {:.0f} % of their sum", got.n, 100 * largest)
          : "";
  fail_statistical(what + ", and its noise",
                   fmt::format("{}: estimates with a standard deviation of {:.3g}, mean {}{}",
                               too_noisy(average), got.deviation[channel], brief(got.value), one),
                   fmt::format("a standard deviation of {:.3g} at most", most));
}

}  // namespace

Mean mean_of(const std::vector<Rgb>& draws) {
  const double n = static_cast<double>(draws.size());
  Rgb mean, squares, sum, largest, farthest, second;
  for (const Rgb& draw : draws) {
    mean += draw / n;
    sum += absolute(draw);
    largest = larger(largest, absolute(draw));
  }
  for (const Rgb& draw : draws) {
    Rgb square = (draw - mean) * (draw - mean);
    squares += square;
    for (int channel = 0; channel < 3; ++channel) {
      if (square[channel] > farthest[channel]) std::swap(square[channel], farthest[channel]);
      second[channel] = std::max(second[channel], square[channel]);
    }
  }
  Rgb share;
  for (int channel = 0; channel < 3; ++channel) {
    if (sum[channel] > 0) share[channel] = largest[channel] / sum[channel];
  }
  // Weights may have a variance but no fourth moment. Then one draw of thousands is sometimes so large
  // that the measured variance is its own. Three such draws in one set are too rare to be seen.
  const Rgb deviation = square_root((squares - farthest - second) / std::max(1.0, n - 3));
  return {mean, square_root(squares / (n * (n - 1))), static_cast<int>(draws.size()), share,
          deviation};
}

Noise noise_of(const std::vector<Rgb>& usual, double factor) {
  const Mean mean = mean_of(usual);
  const double n = static_cast<double>(mean.n);
  Rgb fourth;
  for (const Rgb& draw : usual) {
    const Rgb squared = (draw - mean.value) * (draw - mean.value);
    fourth += squared * squared / n;
  }
  Noise noise{factor * std::sqrt(n) * mean.standard_error};
  for (int channel = 0; channel < 3; ++channel) {
    const double variance = n * mean.standard_error[channel] * mean.standard_error[channel];
    if (variance > 0) {
      noise.kurtosis = std::max(noise.kurtosis, fourth[channel] / (variance * variance));
    }
  }
  return noise;
}

void expect_mean(const std::string& what, const Mean& got, Rgb expected, double slack) {
  for (int channel = 0; channel < 3; ++channel) {
    const double allowed = kStandardErrors * got.standard_error[channel] + slack;
    if (!(std::abs(got.value[channel] - expected[channel]) <= allowed)) {
      fail_mean(what, got, expected, allowed, channel);
    }
    if (hangs_on_one_draw(got, channel)) fail_one_draw(what, got, channel, Average::far);
  }
}

void expect_mean(const std::string& what, const Mean& got, Rgb expected, const Noise& at_most,
                 double slack) {
  for (int channel = 0; channel < 3; ++channel) {
    const double off = std::abs(got.value[channel] - expected[channel]);
    const double allowed = kStandardErrors * got.standard_error[channel] + slack;
    if (!(off <= allowed)) fail_mean(what, got, expected, allowed, channel);
    const double most = most_measured(at_most, channel, got.n);
    const bool close = off <= kStandardErrors * most / std::sqrt(got.n) + slack;
    const Average average = close ? Average::close : Average::far;
    if (!(got.deviation[channel] <= most + slack)) {
      fail_noise(what, got, most + slack, channel, average);
    }
    if (hangs_on_one_draw(got, channel)) fail_one_draw(what, got, channel, average);
  }
}

void expect_noise(const std::string& what, const Mean& got, const Noise& at_most, double slack) {
  for (int channel = 0; channel < 3; ++channel) {
    const double most = most_measured(at_most, channel, got.n) + slack;
    if (!(got.deviation[channel] <= most)) fail_noise(what, got, most, channel, Average::unknown);
  }
}

}  // namespace grader::check
