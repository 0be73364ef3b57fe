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

}  // namespace
}  // namespace grader::check
