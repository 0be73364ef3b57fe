#include "grader/check/language/curve.h"
#include "grader/tasks/adaptive_pixel/inputs.h"

#include <algorithm>
#include <cmath>

namespace grader::check {
namespace {

using namespace adaptive_pixel_inputs;

constexpr AdaptiveSettings kUsual{.max_samples = 256, .batch = 32, .tolerance = 0.1};

// A pixel whose samples are `rare` with probability `chance`, else `usual`, and whether it has met
// a rare sample.
struct Pixel {
  PixelEstimate estimate;
  bool has_met = false;    // among the samples that it took
  double mean_of_all = 0;  // of the largest number of samples
};

Pixel pixel_of(double chance, double rare, double usual, const AdaptiveSettings& settings) {
  pt::Sampler values(*sampler_seed()), sampler(*sampler_seed());
  Pixel pixel;
  double sum = 0;
  int drawn = 0;
  const auto next = [&] {
    const double value = values.next_1d() < chance ? rare : usual;
    sum += value;
    ++drawn;
    return value;
  };
  script_radiance({.of_call = [&](int, const pt::Ray&) {
    const double value = next();
    pixel.has_met |= value == rare;
    return pt::gray(value);
  }});
  const pt::Scene empty;
  const pt::View view{empty, pt::Camera{}, {}, 1, 1};
  pixel.estimate = pt::adaptive_pixel(view, 0, 0, settings, sampler);
  while (drawn < settings.max_samples) next();
  pixel.mean_of_all = sum / drawn;
  return pixel;
}

constexpr double kRounding = 1e-12;  // of two sums of the same numbers

// Returns the difference between a pixel and its mean over all samples, as a part of the right
// mean. The mean over all samples has no bias, and shares most of its noise with the pixel.
double too_bright(double chance, double rare, double usual, const AdaptiveSettings& settings) {
  const Pixel pixel = pixel_of(chance, rare, usual, settings);
  const double expected = chance * rare + (1 - chance) * usual;
  const double part = (pixel.estimate.mean.r - pixel.mean_of_all) / expected;
  return std::abs(part) < kRounding ? 0 : part;
}

constexpr int kPixels = 150;

// The expected loss if a pixel is done after a first batch without the rare light. A pixel that has
// met this light has so much noise that it goes on to the end.
double lost(double chance, double rare, double usual, int batch) {
  const double expected = chance * rare + (1 - chance) * usual;
  return std::pow(1 - chance, batch) * (1 - usual / expected);
}

// The interval of 95 % assumes that the variance is known. A batch without the rare light does not
// show this variance.
CURVE(adaptive_pixel, rare_light) {
  return {.title = "Light that a sample rarely meets; batches of 32, at most 256 samples",
          .input = "chance of a sample to meet it",
          .error = "the mean is off by this part",
          .source = "the first batch may not meet it, and the pixel is done",
          .places = by_factors(0.1, 5e-4, 9),
          .promised = {},
          .methods = {{"right/stratified", "stratified points"}},
          .statistic = Statistic::bias,
          .cases = kPixels,
          .theory = [](double chance) { return lost(chance, 1 / chance, 0.1, kUsual.batch); },
          .measure = [](double chance) { return too_bright(chance, 1 / chance, 0.1, kUsual); }};
}

// Returns 1 if a pixel is done before it has met the rare light, else 0. This happens after the
// first batch or never, so one more batch is enough.
double done_before_it_is_met(double chance, AdaptiveSettings settings) {
  settings.max_samples = 2 * settings.batch;
  const Pixel pixel = pixel_of(chance, 1 / chance, 0.1, settings);
  return pixel.estimate.samples < settings.max_samples && !pixel.has_met ? 1 : 0;
}

CURVE(adaptive_pixel, stops_too_early) {
  return {.title = "Pixels that are done before they meet a light; batches of 32",
          .input = "chance of a sample to meet it",
          .error = "share of the pixels that stop too early",
          .source = "(1 - chance) to the power of 32: a batch of equal samples has no noise",
          .places = by_factors(0.15, 5e-4, 9),
          .promised = {},
          .methods = {{"right/stratified", "stratified points"}},
          .statistic = Statistic::mean,
          .cases = 600,
          .theory = [](double chance) { return std::pow(1 - chance, kUsual.batch); },
          .measure = [](double chance) { return done_before_it_is_met(chance, kUsual); }};
}

CURVE(adaptive_pixel, stops_by_batch) {
  return {.title = "Pixels that are done before they meet a light; one sample of a hundred does",
          .input = "samples of the first batch",
          .error = "share of the pixels that stop too early",
          .source = "(1 - chance) to the power of the batch: equal samples have no noise",
          .places = {512, 256, 128, 64, 32, 16, 8},
          .promised = {},
          .methods = {},
          .statistic = Statistic::mean,
          .cases = 600,
          .theory = [](double batch) { return std::pow(0.99, batch); },
          .measure =
              [](double batch) {
                AdaptiveSettings settings = kUsual;
                settings.batch = static_cast<int>(batch);
                return done_before_it_is_met(0.01, settings);
              }};
}

CURVE(adaptive_pixel, stops_by_tolerance) {
  return {
      .title = "Pixels that are done before they meet a light, by the tolerance; batches of 32",
      .input = "tolerance",
      .error = "share of the pixels that stop too early, where one sample of a hundred meets it",
      .source = "a pixel that has seen no noise is done, whatever the tolerance",
      .places = by_factors(1e-3, 1, 7),
      .promised = {},
      .methods = {},
      .statistic = Statistic::mean,
      .cases = 600,
      .theory = [](double) { return std::pow(0.99, kUsual.batch); },
      .measure =
          [](double tolerance) {
            AdaptiveSettings settings = kUsual;
            settings.tolerance = tolerance;
            return done_before_it_is_met(0.01, settings);
          }};
}

CURVE(adaptive_pixel, first_batch) {
  return {.title = "Light that one sample of a hundred meets, and the size of a batch",
          .input = "samples of the first batch",
          .error = "the mean is off by this part",
          .source = "(1 - chance) to the power of the batch is the chance to see nothing",
          .places = {300, 200, 128, 64, 32, 16, 8},
          .promised = {},
          .methods = {},
          .statistic = Statistic::bias,
          .cases = kPixels,
          .theory = [](double batch) { return lost(0.01, 100, 0.1, static_cast<int>(batch)); },
          .measure =
              [](double batch) {
                AdaptiveSettings settings = kUsual;
                settings.batch = static_cast<int>(batch);
                settings.max_samples = std::max(settings.max_samples, 2 * settings.batch);
                return too_bright(0.01, 100, 0.1, settings);
              }};
}

CURVE(adaptive_pixel, tolerance) {
  return {.title = "Light that one sample of a hundred meets, and the tolerance; batches of 32",
          .input = "tolerance",
          .error = "the mean is off by this part",
          .source = "a pixel that has seen no noise is done, whatever the tolerance",
          .places = by_factors(1e-3, 1, 7),
          .promised = {},
          .methods = {},
          .statistic = Statistic::bias,
          .cases = kPixels,
          .theory = [](double) { return lost(0.01, 100, 0.1, kUsual.batch); },
          .measure =
              [](double tolerance) {
                AdaptiveSettings settings = kUsual;
                settings.tolerance = tolerance;
                return too_bright(0.01, 100, 0.1, settings);
              }};
}

CURVE(adaptive_pixel, fireflies) {
  return {.title = "One sample in a thousand is a firefly; at most 256 samples",
          .input = "radiance of a firefly, where other samples have 1",
          .error = "the mean is off by this part",
          .source = "most pixels are done before they meet one",
          .places = by_factors(1, 1e5, 11),
          .promised = {},
          .methods = {{"right/stratified", "stratified points"}},
          .statistic = Statistic::bias,
          .cases = kPixels,
          .theory = [](double radiance) { return lost(1e-3, radiance, 1, kUsual.batch); },
          .measure = [](double radiance) { return too_bright(1e-3, radiance, 1, kUsual); }};
}

// Samples that are in turns above and below 1. The tolerance needs 1,041 samples, which is 33
// batches of 32.
CURVE(adaptive_pixel, little_noise) {
  return {.title = "Samples that hardly differ",
          .input = "standard deviation over mean",
          .error = "relative error of the number of samples",
          .source =
              "sum of squares minus square of sum: a difference of nearly equal numbers "
              "(Welford 1962)",
          .places = by_factors(0.5, 1e-12, 19),
          .promised = {{1.7e-3, 0.5}},
          .methods = {{"methods/sum_of_squares", "sum of squares"},
                      {"methods/sum_of_squares", "sum of squares, single precision", true}},
          .cases = 1,
          .measure = [](double deviation) {
            constexpr int kRight = 33 * 32;
            Case c;
            c.settings = {.max_samples = 4096,
                          .batch = 32,
                          .tolerance = 1.96 * deviation / std::sqrt(1040.5)};
            for (int i = 0; i < c.settings.max_samples; ++i) {
              c.seen.push_back(pt::gray(i % 2 == 0 ? 1 + deviation : 1 - deviation));
            }
            return std::abs(static_cast<double>(ask(c).estimate.samples) / kRight - 1);
          }};
}

}  // namespace
}  // namespace grader::check
