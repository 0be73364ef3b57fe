#pragma once

#include "grader/check/closed_forms.h"
#include "grader/tasks/trace_path/cases.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>

// Direct light that light sampling and hemisphere sampling find in different places.

namespace grader::check::paths {

// A patch under two rectangles. One is only in the list of lights, the other is only a surface.
// Light sampling finds the first and hemisphere sampling the second, and their right answers
// differ.
struct HalfLights {
  Situation situation;
  PathSettings settings;
  Rgb expected;
  std::uint64_t seed = 0;
};

inline void showValue(const HalfLights& c, std::ostream& out) {
  showValue(c.situation, out);
  out << fmt::format("\nbounces {} to 1; direct light by {}, samples {}", c.settings.from,
                     c.settings.direct == Direct::lights ? "lights" : "hemisphere",
                     c.settings.light_samples);
}

inline rc::Gen<HalfLights> under_half_lights() {
  return rc::gen::exec([] {
    SceneMaker maker({});
    const Rectangle left{{-1, 0, 1}, {0, 1, 0}, {1, 0, 0}}, right{{1, 0, 1}, {0, 1, 0}, {1, 0, 0}};
    const Rgb of_left = *color(1, 4), of_right = *color(5, 9);
    maker.rectangle(left, of_left, Body::none).surface(right, {}, of_right);
    // The samples are for each light, however many are in the list. These bring nothing: they are
    // below the horizon.
    const Direct direct = *either_way();
    for (int below = direct == Direct::hemisphere ? 39 : 4; below > 0; --below) {
      maker.directional_light({0, 0, -1}, pt::gray(1));
    }
    HalfLights c{maker.patch(*color(0.1, 1), *direction_above()).done(), {}, {}, *sampler_seed()};
    c.settings.from = *whole(0, 1);
    c.settings.direct = direct;
    c.settings.light_samples = *rc::gen::element(1, 2, 8, 40);
    c.expected = c.situation.expected;
    if (c.settings.direct == Direct::hemisphere) {
      c.expected = c.situation.point.albedo * of_right / pt::kPi *
                   cosine_of_polygon(right.corners(), {}, {0, 0, 1});
    }
    return c;
  });
}

inline std::vector<Rgb> estimates(const HalfLights& c, int light_samples) {
  PathSettings settings = c.settings;
  settings.light_samples = light_samples;
  return repeat<pt::trace_path>(kCalls, c.seed, c.situation.scene, c.situation.point, settings);
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
// the two measured noises.
inline void expect_a_tenth_of_the_noise(const HalfLights& c) {
  const Noise one = noise_of(estimates(c, 1), 1), many = noise_of(estimates(c, 100), 1);
  expect(one.deviation.g > 0, "estimates with one sample of direct light that vary",
         fmt::format("a standard deviation of {:.3g}", one.deviation.g));
  const double ratio = many.deviation.g / one.deviation.g;
  const double doubt = kStandardErrors * std::sqrt((one.kurtosis + many.kurtosis) / (4 * kCalls));
  const double most = 0.1 * (1 + doubt);
  expect(ratio < most,
         fmt::format("100 samples of direct light with {:.2g} of the noise of one sample", most),
         fmt::format("{:.2g} of the noise", ratio));
}

}  // namespace grader::check::paths
