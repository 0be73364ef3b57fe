#include "grader/check/language/curve.h"
#include "grader/check/language/property.h"
#include "grader/tasks/estimate_pixel/inputs.h"

#include <algorithm>
#include <cmath>

namespace grader::check {
namespace {

using namespace estimate_pixel_inputs;

CURVE(estimate_pixel, many_samples) {
  return {.title = "The mean of many equal samples",
          .input = "samples",
          .error = "relative error of the mean",
          .source = "each addition to a large sum is rounded (Higham 2002, chapter 4)",
          .places = by_factors(10, 1e5, 9),
          .promised = {{10, 1e5, [](double n) { return std::max(kColorPrecision, n * 1e-7); }}},
          .methods = {{"right/float_sum", "single precision"}},
          .cases = 1,
          .measure = [](double samples) {
            const Estimate got =
                estimate({pt::Camera{}, 8, 5, 3, 2}, static_cast<int>(samples),
                         pt::Sampler(*sampler_seed()), {.values = {pt::gray(0.1)}});
            return std::abs(got.mean.r / 0.1 - 1);
          }};
}

CURVE(estimate_pixel, one_bright_sample) {
  constexpr int kSamples = 64;
  return {.title = "One sample that is far brighter than the others",
          .input = "its radiance, in radiances of the other 63",
          .error = "relative error of the mean",
          .source = "single precision ends at 3.4e38, double precision at 1.8e308",
          .places = by_factors(1, 1e60, 21),
          .promised = {{1, 1e6, at_most(kColorPrecision)}},
          .methods = {{"right/float_sum", "single precision"}},
          .cases = 5,
          .measure = [](double bright) {
            std::vector<pt::Rgb> values(kSamples, pt::gray(1));
            values[*whole(0, kSamples - 1)] = pt::gray(bright);
            const Estimate got = estimate({pt::Camera{}, 8, 5, 3, 2}, kSamples,
                                          pt::Sampler(*sampler_seed()), {.values = values});
            return std::abs(got.mean.r / ((bright + kSamples - 1) / kSamples) - 1);
          }};
}

}  // namespace
}  // namespace grader::check
