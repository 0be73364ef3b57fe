#include "grader/check/curve.h"
#include "grader/tasks/adaptive_pixel/cases.h"

#include <cmath>

namespace grader::check {
namespace {

using namespace adaptive;

constexpr AdaptiveSettings kUsual{.max_samples = 1024, .batch = 32, .tolerance = 0.1};

// A pixel whose samples are `rare` with the chance, else `usual`, and whether it has met a rare one.
struct Pixel {
  PixelEstimate estimate;
  bool has_met = false;
};

Pixel pixel_of(double chance, double rare, double usual, const AdaptiveSettings& settings) {
  pt::Sampler values(*sampler_seed()), sampler(*sampler_seed());
  Pixel pixel;
  script_radiance([&](int, const pt::Ray&) {
    const bool meets = values.next_1d() < chance;
    pixel.has_met |= meets;
    return pt::gray(meets ? rare : usual);
  });
  const pt::Scene empty;
  const pt::View view{empty, pt::Camera{}, {}, 1, 1};
  pixel.estimate = pt::adaptive_pixel(view, 0, 0, settings, sampler);
  return pixel;
}

// How far the mean of many pixels is below the mean of their samples, as a part of it.
double too_dark(double chance, double rare, double usual, const AdaptiveSettings& settings) {
  constexpr int kPixels = 20;
  const double expected = chance * rare + (1 - chance) * usual;
  double sum = 0;
  for (int i = 0; i < kPixels; ++i) {
    sum += pixel_of(chance, rare, usual, settings).estimate.mean.r / kPixels;
  }
  return std::abs(1 - sum / expected);
}

// The loss of a pixel that is done after a first batch without the rare light, by the chance that it
// is. A pixel that has met it sees so much noise that it goes on to the end.
double lost(double chance, double rare, double usual, int batch) {
  const double expected = chance * rare + (1 - chance) * usual;
  return std::pow(1 - chance, batch) * (1 - usual / expected);
}

// The interval of 95 % assumes that the variance is known. A batch in which the rare light is missing
// knows nothing of it.
CURVE(adaptive_pixel, rare_light) {
  return {.title = "Light that a sample rarely meets; batches of 32, at most 1,024 samples",
          .input = "chance of a sample to meet it",
          .error = "the mean is off by this part",
          .source = "the first batch may not meet it, and the pixel is done",
          .places = by_factors(0.5, 5e-4, 10),
          .promised = {},
          .methods = {{"right/stratified", "stratified points"}},
          .statistic = Statistic::median,
          .cases = 5,
          .theory = [](double chance) { return lost(chance, 1 / chance, 0.1, kUsual.batch); },
          .measure = [](double chance) { return too_dark(chance, 1 / chance, 0.1, kUsual); }};
}

// Returns 1 if a pixel is done before it has met the rare light, else 0.
double done_before_it_is_met(double chance, const AdaptiveSettings& settings) {
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
          .cases = 2000,
          .theory = [](double chance) { return std::pow(1 - chance, kUsual.batch); },
          .measure = [](double chance) { return done_before_it_is_met(chance, kUsual); }};
}

CURVE(adaptive_pixel, first_batch) {
  return {.title = "Light that one sample of a hundred meets, and the size of a batch",
          .input = "samples of the first batch",
          .error = "the mean is off by this part",
          .source = "(1 - chance) to the power of the batch is the chance to see nothing",
          .places = {512, 256, 128, 64, 32, 16, 8},
          .promised = {},
          .methods = {},
          .statistic = Statistic::median,
          .cases = 5,
          .theory = [](double batch) { return lost(0.01, 100, 0.1, static_cast<int>(batch)); },
          .measure =
              [](double batch) {
                AdaptiveSettings settings = kUsual;
                settings.batch = static_cast<int>(batch);
                return too_dark(0.01, 100, 0.1, settings);
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
          .statistic = Statistic::median,
          .cases = 5,
          .theory = [](double) { return lost(0.01, 100, 0.1, kUsual.batch); },
          .measure =
              [](double tolerance) {
                AdaptiveSettings settings = kUsual;
                settings.tolerance = tolerance;
                return too_dark(0.01, 100, 0.1, settings);
              }};
}

CURVE(adaptive_pixel, fireflies) {
  return {.title = "One sample in a thousand is a firefly; at most 1,024 samples",
          .input = "radiance of a firefly, where other samples have 1",
          .error = "the mean is off by this part",
          .source = "most pixels are done before they meet one",
          .places = by_factors(1, 1e5, 11),
          .promised = {},
          .methods = {{"right/stratified", "stratified points"}},
          .statistic = Statistic::median,
          .cases = 5,
          .theory = [](double radiance) { return lost(1e-3, radiance, 1, kUsual.batch); },
          .measure = [](double radiance) { return too_dark(1e-3, radiance, 1, kUsual); }};
}

// Samples that are in turns above and below 1. The tolerance asks for 1,041 of them, which is 33
// batches of 32.
CURVE(adaptive_pixel, little_noise) {
  return {.title = "Samples that hardly differ",
          .input = "standard deviation over mean",
          .error = "relative error of the number of samples",
          .source =
              "sum of squares minus square of sum: a difference of nearly equal numbers "
              "(Welford 1962)",
          .places = by_factors(0.5, 1e-12, 19),
          .promised = {1.7e-3, 0.5, 0},
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
