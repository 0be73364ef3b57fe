#pragma once

#include "grader/check/wild/radiances.h"
#include "grader/check/wild/search.h"
#include "grader/check/wild/wild_scene.h"
#include "grader/tasks/adaptive_pixel/inputs.h"

#include <algorithm>
#include <limits>
#include <memory>

// Calls of adaptive_pixel that are explained one by one.

namespace grader::check::adaptive_pixel_inputs {

class WildPixel : public WildInput {
 public:
  WildPixel(const WildRadiances& radiances, const AdaptiveSettings& settings)
      : radiances_(radiances), settings_(settings) {}

  // The judge's own mock answers radiance(), so that it has the record.
  Explanations ask(int n, std::uint64_t seed) const override {
    constexpr int kMost = std::numeric_limits<int>::max(),
                  kMaxValues = 4000;  // then the last one again
    const int values = settings_.max_samples == kMost ? kMaxValues : settings_.max_samples;
    Case c{radiances_.values(values), "", settings_, {}};
    c.width = c.height = 16;
    c.x = static_cast<int>(seed % 16);
    Explanations all;
    for (int i = 0; i < n; ++i) {
      const pt::Sampler start = pt::Sampler::for_pixel(seed, i, 0);
      const Answer answer = adaptive_pixel_inputs::ask(c, {}, start);
      std::vector<Rgb> seen;
      for (std::size_t k = 0; k < answer.calls.size(); ++k)
        seen.push_back(c.seen[std::min(k, c.seen.size() - 1)]);
      explain::Explanation found = explain::explain_adaptive(settings_, answer.estimate, seen);
      if (found.fault == explain::Fault::none) {
        found = explain::explain_sampler("passes_the_settings_on", start.state(),
                                         answer.sampler.state());
      }
      all.push_back(found);
    }
    return all;
  }
  std::vector<WildPointer> smaller() const override {
    std::vector<WildPointer> all;
    const auto add = [&](int batch, int most) {
      if (batch < 2 || most < batch || (batch == settings_.batch && most >= settings_.max_samples))
        return;
      AdaptiveSettings less = settings_;
      less.batch = batch;
      less.max_samples = most;
      all.push_back(std::make_shared<WildPixel>(radiances_, less));
    };
    for (const int most :
         {2 * settings_.batch, settings_.max_samples / 2, settings_.max_samples - 1}) {
      add(settings_.batch, most);
    }
    add(settings_.batch / 2, settings_.max_samples);
    return all;
  }
  std::string text() const override {
    return fmt::format("batch {}, at most {} samples, tolerance {:.4g}\n{}", settings_.batch,
                       settings_.max_samples, settings_.tolerance, radiances_.text());
  }
  int samples() const override { return std::min(settings_.max_samples, 1000); }

 private:
  WildRadiances radiances_;
  AdaptiveSettings settings_;
};

// A few may go on for ever, and stop soon because their radiances are alike.
inline WildPointer any_pixel(RandomNumbers& random) {
  WildRadiances radiances = wild_radiances(random);
  AdaptiveSettings s;
  s.batch = by_chance(random, 0.3) ? random.whole(2, 5) : static_cast<int>(by_size(random, 2, 100));
  s.tolerance = by_size(random, 1e-3, 1);
  s.max_samples = s.batch + static_cast<int>(by_size(random, 1, 800));
  if (by_chance(random, 0.01)) {
    radiances = rarely_bright(random);
    s.tolerance = std::min(s.tolerance, 0.02);
    const bool longest = by_chance(random, 0.05);
    s.max_samples =
        static_cast<int>(longest ? by_size(random, 6000, 60000) : by_size(random, 800, 6000));
  }
  if (by_chance(random, 0.1)) {
    radiances.kind =
        random.whole(0, 1) == 0 ? WildRadiances::Kind::constant : WildRadiances::Kind::uniform;
    s.max_samples = std::numeric_limits<int>::max();
    s.tolerance = std::max(0.05, s.tolerance);
  }
  return std::make_shared<WildPixel>(radiances, s);
}

inline Explanations usual_calls(std::uint64_t seed) {
  Explanations all;
  for (int i = 0; i < 500; ++i) {
    RandomNumbers random(seed + static_cast<std::uint64_t>(i));
    const AdaptiveSettings settings{random.whole(16, 160), random.whole(2, 16),
                                    by_size(random, 1e-2, 0.5)};
    const WildPixel pixel(wild_radiances(random), settings);
    for (const auto& each : pixel.ask(1, seed)) all.push_back(each);
  }
  return all;
}

inline WildTask wild_task() { return {usual_calls, any_pixel, 2000, 1}; }

}  // namespace grader::check::adaptive_pixel_inputs
