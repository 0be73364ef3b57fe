#include "grader/check/generators/random_numbers.h"
#include "grader/check/language/bad_inputs.h"
#include "grader/check/language/property.h"
#include "grader/tasks/estimate_pixel/inputs.h"

#include <algorithm>
#include <cmath>

namespace grader::check {
namespace {

using namespace estimate_pixel_inputs;

SEARCH(estimate_pixel, mean) {
  return {.title = "the mean of samples of very different sizes",
          .measure = "1 is what the contract allows",
          .badness = [] {
            const int samples = *whole(1, 300);
            const double spread = *real(0, 10), level = *magnitude(1e-4, 1e6);
            const std::uint64_t seed = *sampler_seed();
            show_input([&] {
              return std::to_string(samples) + " samples, " + show(level) + " times 10 to the " +
                     show(spread) + " xi, seed " + std::to_string(seed);
            });
            RandomNumbers make(seed);
            long double sum = 0;
            const Estimate got = estimate({pt::Camera{}, 8, 5, 3, 2}, samples, pt::Sampler(seed),
                                          {.of_call = [&](int, const pt::Ray&) {
                                            const double value =
                                                level * std::pow(10, -spread * make.between(0, 1));
                                            sum += value;
                                            return pt::gray(value);
                                          }});
            const long double right = sum / samples;
            return static_cast<double>(std::abs(got.mean.r - right) / (kColorPrecision * right));
          }};
}

}  // namespace
}  // namespace grader::check
