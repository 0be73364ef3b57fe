#pragma once

#include "grader/check/wild/radiances.h"
#include "grader/check/wild/search.h"
#include "grader/check/wild/wild_scene.h"
#include "grader/tasks/estimate_pixel/inputs.h"

#include <algorithm>
#include <cmath>
#include <memory>

// Calls of estimate_pixel that are explained one by one.

namespace grader::check::estimate_pixel_inputs {

class WildPixel : public WildInput {
 public:
  WildPixel(const WildRadiances& radiances, int count) : radiances_(radiances), count_(count) {}

  // The judge's own mock answers radiance(), so that it has the record.
  Explanations ask(int n, std::uint64_t seed) const override {
    const Pixel p{{}, 16, 16, static_cast<int>(seed % 16), 3};
    const std::vector<pt::Rgb> values = radiances_.values(count_);
    Explanations all;
    for (int i = 0; i < n; ++i) {
      const pt::Sampler start = pt::Sampler::for_pixel(seed, i, 0);
      const Estimate e = estimate(p, count_, start, {.values = values, .numbers = 2});
      std::vector<pt::Rgb> seen;
      for (std::size_t k = 0; k < e.calls.size(); ++k)
        seen.push_back(values[std::min(k, values.size() - 1)]);
      explain::Explanation found = explain::explain_pixel(count_, e.mean, seen);
      if (found.fault == explain::Fault::none) {
        found = explain::explain_sampler("draws_from_the_callers_sampler", start.state(),
                                         e.sampler.state());
      }
      all.push_back(found);
    }
    return all;
  }
  std::vector<WildPointer> smaller() const override {
    std::vector<WildPointer> all;
    for (const int less : {2, 16, count_ / 2, count_ - 1}) {
      if (less >= 1 && less < count_) all.push_back(std::make_shared<WildPixel>(radiances_, less));
    }
    return all;
  }
  std::string text() const override {
    return fmt::format("samples: {}\n{}", count_, radiances_.text());
  }
  int samples() const override { return count_; }

 private:
  WildRadiances radiances_;
  int count_;
};

inline WildPointer any_pixel(RandomNumbers& random) {
  // Few calls are long, of any length, half of them of a round one.
  double samples =
      by_chance(random, 0.1) ? by_size(random, 6000, 60000) : by_size(random, 600, 6000);
  if (by_chance(random, 0.5)) samples = 64 * std::round(samples / 64);
  if (by_chance(random, 0.01)) {
    return std::make_shared<WildPixel>(rarely_bright(random), static_cast<int>(samples));
  }
  samples = by_size(random, 1, 300);
  return std::make_shared<WildPixel>(wild_radiances(random), static_cast<int>(samples));
}

inline Explanations usual_calls(std::uint64_t seed) {
  Explanations all;
  for (int i = 0; i < 500; ++i) {
    RandomNumbers random(seed + static_cast<std::uint64_t>(i));
    const WildPixel pixel(wild_radiances(random), random.whole(1, 20));
    for (const auto& each : pixel.ask(1, seed)) all.push_back(each);
  }
  return all;
}

inline WildTask wild_task() { return {usual_calls, any_pixel, 2000, 1}; }

}  // namespace grader::check::estimate_pixel_inputs
