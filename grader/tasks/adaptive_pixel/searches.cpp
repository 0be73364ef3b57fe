#include "grader/check/generators/random_numbers.h"
#include "grader/check/language/bad_inputs.h"
#include "grader/tasks/adaptive_pixel/counts.h"
#include "grader/tasks/adaptive_pixel/inputs.h"

#include <cmath>

namespace grader::check {
namespace {

using namespace adaptive_pixel_inputs;

// Samples with any noise, all at one level or a few much brighter, and a tolerance with which most
// pixels end somewhere between the first batch and the last.
Case any_pixel() {
  Case c;
  c.settings = {.max_samples = *whole(1, 200), .batch = *whole(1, 40), .tolerance = 0};
  c.seed = *sampler_seed();
  const double level = *magnitude(1e-4, 1e6), noise = *magnitude(1e-9, 2), rare = *real(0, 1);
  const double bright = *magnitude(1, 1e4);
  c.settings.tolerance = *magnitude(0.1, 10) * noise / std::sqrt(c.settings.max_samples);
  RandomNumbers make(c.seed);
  for (int i = 0; i < c.settings.max_samples; ++i) {
    const double factor = make.between(0, 1) < 0.02 * rare ? bright : 1;
    c.seen.push_back(pt::gray(level * factor * (1 + noise * make.between(0, 1))));
  }
  c.kind = "noise " + show(noise) + ", level " + show(level) + ", bright " + show(bright) +
           ", seed " + std::to_string(c.seed);
  return c;
}

SEARCH(adaptive_pixel, count_and_mean) {
  return {.title = "a pixel with noise of any size: the number of samples, and their mean",
          .measure = "1 is what the contract allows of the mean; a wrong number is broken",
          .badness = [] {
            const Case c = any_pixel();
            show_case(c);
            const PixelEstimate got = ask(c).estimate;
            const int n = got.samples;
            if (!may_stop(c, n, true) && !may_stop(c, n, false)) return kBroken;
            long double sum = 0;
            for (int i = 0; i < n; ++i) sum += c.seen[i].r;
            const long double right = sum / n;
            return static_cast<double>(std::abs(got.mean.r - right) / (kColorPrecision * right));
          }};
}

}  // namespace
}  // namespace grader::check
