#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/generators/random_numbers.h"
#include "grader/check/language/property.h"
#include "grader/check/language/repeat.h"
#include "grader/check/language/two_numbers.h"
#include "grader/check/scenes/closed_forms.h"
#include "grader/check/scenes/scenes.h"
#include "grader/check/scenes/textbook.h"
#include "grader/tasks/direct_lights/wild.h"
#include "pt/tasks/direct_lights.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

// Estimates of direct light, and whether they are right.

namespace grader::check::direct_lights_inputs {

using pt::Rgb;

// The error that the contract allows in addition to noise: 1e-5 of the value for the task, the same
// for diffuse_f, which the task may call, and a millionth of each light for its cosine.
inline double tolerance(const Situation& s) {
  return 2 * kColorPrecision * max_channel(s.expected) +
         1e-6 * max_channel(s.point.albedo * s.facing) / pt::kPi;
}

inline std::vector<Rgb> estimates(const Situation& s, int calls, int samples) {
  return repeat<pt::direct_lights>(calls, draw("seed", sampler_seed()), s.scene, s.point, samples);
}

// The error from rare draws. A draw that adds about as much as the mean may be so rare that it does
// not occur in this many draws. The measured noise then does not contain it. In multiple importance
// sampling, BSDF samples that meet a small light are rare draws of this kind.
inline double missed(const Situation& s, int draws) {
  constexpr double kRare = 30;
  return kRare / draws * max_channel(s.expected);
}

// The more samples or lights per call, the fewer calls.
inline void expect_estimate(const Situation& s, int samples) {
  if (needs_no_mean(s, samples)) return;
  const int lights = std::max(1, static_cast<int>(s.scene.lights.size()));
  const int calls = std::clamp(20000 / samples / lights, 100, 3000);
  expect_mean(fmt::format("the mean, {} samples per call", samples),
              mean_of(estimates(s, calls, samples)), s.expected, noise_of_lights(s, samples),
              tolerance(s) + missed(s, calls * samples));
}

// Two lamps, level and one above the point: along x in front of it, and along y beside it. The light
// that a draw of a lamp brings falls along its longer side, so it tells where the draw was. The
// other side is so narrow that it does not matter.
enum class Lamp { along_x, along_y };

inline constexpr double kLampWidth = 1e-3, kLampLength = 2.7, kLampFrom = 0.3;

inline Rectangle long_lamp(Lamp lamp, bool narrow_u) {
  const pt::Vec3 along = lamp == Lamp::along_x ? pt::Vec3{1, 0, 0} : pt::Vec3{0, 1, 0};
  const pt::Vec3 aside = cross({0, 0, 1}, along);
  const pt::Vec3 center = (kLampFrom + kLampLength / 2) * along + pt::Vec3{0, 0, 1};
  if (narrow_u) return {center, kLampWidth * aside, kLampLength * along};
  return {center, kLampLength * along, -kLampWidth * aside};
}

// Adds a surface that hides one half of the lamp, along its middle.
inline void hide_a_half(SceneMaker& maker, const Rectangle& lamp, bool narrow_u) {
  const Rectangle half =
      narrow_u ? lamp.part(-0.5, 0.5, -0.1, 1.1) : lamp.part(-0.1, 1.1, -0.5, 0.5);
  maker.surface(half.scaled(0.5), pt::gray(0.5));
}

// Judges where the draws of a lamp were along it, and whether another draw, or the same one, was in the
// half of a lamp that is not hidden. `light` is that of the whole lamp, whose solid angle is given.
// The number that chose the place is uniform on the lamp or, if draws are uniform in solid angle, in
// the sine of the angle to the normal. Each half stands for any number of its half of [0, 1).
inline void expect_independent_halves(const std::string& what, const std::vector<double>& light,
                                      const std::vector<bool>& is_lit, double solid_angle) {
  const double area = kLampWidth * kLampLength;
  const auto sine = [](double x) { return x / std::sqrt(1 + x * x); };
  const double nearest = sine(kLampFrom), farthest = sine(kLampFrom + kLampLength);
  RandomNumbers within(draw("seed of the halves", sampler_seed()));
  expect(std::ranges::count(is_lit, true) < std::ssize(is_lit),
         "no light from the half of a lamp that a surface hides", "light from every draw");
  for (const bool by_area : {true, false}) {
    std::vector<NumberPair> pairs;
    for (std::size_t i = 0; i < light.size(); ++i) {
      if (!(light[i] > 0)) continue;  // a method that draws more than lights may miss it
      const double cosine = std::min(1.0, light[i] * pt::kPi / solid_angle);
      const double squared = std::sqrt(area / (pt::kPi * light[i])) - 1;  // the distance along it
      const double place = by_area
                               ? (std::sqrt(std::max(0.0, squared)) - kLampFrom) / kLampLength
                               : (std::sqrt(1 - cosine * cosine) - nearest) / (farthest - nearest);
      pairs.push_back({place, within.between(is_lit[i] ? 0 : 0.5, is_lit[i] ? 0.5 : 1)});
    }
    expect_two_numbers(what, pairs);
  }
}

// The solid angle of a lamp, seen from the point.
inline double solid_angle_of(const Rectangle& lamp) {
  const std::vector<pt::Vec3> c = lamp.corners();
  return solid_angle(c[0], c[1], c[2], {}) + solid_angle(c[0], c[2], c[3], {});
}

inline constexpr int kDrawsOfLamps = 1500;

// A lamp, and the same lamp with one half hidden.
struct OpenAndHidden {
  Situation open, hidden;
};

inline void showValue(const OpenAndHidden& both, std::ostream& out) { showValue(both.hidden, out); }

inline rc::Gen<OpenAndHidden> lamp_with_a_hidden_half(const Rectangle& lamp, bool narrow_u) {
  return rc::gen::exec([=] {
    const Pose around = *pose();
    const auto made = [&](bool hides) {
      SceneMaker maker(around);
      maker.rectangle(lamp, pt::gray(1), Body::none);
      if (hides) hide_a_half(maker, lamp, narrow_u);
      return maker.point(pt::gray(1), {0, 0, 1}).done();
    };
    return OpenAndHidden{made(false), made(true)};
  });
}

// The same draws with one half of the lamp hidden and with none.
inline void expect_independent_sides(bool narrow_u) {
  const Rectangle lamp = long_lamp(Lamp::along_x, narrow_u);
  const OpenAndHidden both = *lamp_with_a_hidden_half(lamp, narrow_u);
  const auto seed = draw("seed", sampler_seed());
  const auto found = [seed](const Situation& s) {
    return repeat<pt::direct_lights>(kDrawsOfLamps, seed, s.scene, s.point, 1);
  };
  std::vector<double> light;
  std::vector<bool> is_lit;
  for (const Rgb& one : found(both.open)) light.push_back(one.g);
  for (const Rgb& one : found(both.hidden)) is_lit.push_back(one.g > 0);
  expect_independent_halves("where the draws of a rectangle are on its two sides", light, is_lit,
                            solid_angle_of(lamp));
}

// A red lamp, and a green one of which a half is hidden.
inline rc::Gen<Situation> red_and_green_lamp(const Rectangle& red, bool hidden_first) {
  return rc::gen::exec([=] {
    SceneMaker maker(*pose());
    const Rectangle green = long_lamp(Lamp::along_y, false);
    if (!hidden_first) maker.rectangle(red, {1, 0, 0}, Body::none);
    maker.rectangle(green, {0, 1, 0}, Body::none);
    if (hidden_first) maker.rectangle(red, {1, 0, 0}, Body::none);
    hide_a_half(maker, green, false);
    return maker.point(pt::gray(1), {0, 0, 1}).done();
  });
}

inline void expect_independent_lights(bool hidden_first) {
  const Rectangle red = long_lamp(Lamp::along_x, true);
  const Situation s = *red_and_green_lamp(red, hidden_first);
  std::vector<double> light;
  std::vector<bool> is_lit;
  int of_red = 0, of_green = 0, of_both = 0;
  for (const Rgb& one : estimates(s, kDrawsOfLamps, 1)) {
    light.push_back(one.r);
    is_lit.push_back(one.g > 0);
    of_red += one.r > 0;
    of_green += one.g > 0;
    of_both += one.r > 0 && one.g > 0;
  }
  // If one did not depend on the other, at least a hundred would have both.
  expect(of_both > 0 || of_red * of_green < 100 * kDrawsOfLamps,
         "a draw of each light in every estimate",
         fmt::format(
             "{} estimates with light of a red lamp, {} with light of a green one, and none with "
             "both: one of the lights is chosen",
             of_red, of_green));
  expect_independent_halves("where the draws of two lights are", light, is_lit,
                            solid_angle_of(red));
}

// Without randomness, every single estimate has to be right.
inline void expect_always(const Situation& s, int samples) {
  for (const Rgb& one : estimates(s, 8, samples)) {
    expect_near(fmt::format("each estimate, {} samples per call", samples), one, s.expected,
                tolerance(s));
  }
}

// The noise of many samples is compared with that of one sample, `of_one`, which is the submission's
// own. The noise of one sample has the same limit as everywhere. The variances of two sets of n
// draws differ by less than the part `doubt`.
inline void expect_less_noise(const Situation& s, const std::vector<Rgb>& of_one, int samples,
                              int calls) {
  const double doubt = 9.5 / std::sqrt(of_one.size());
  Noise most = noise_of(of_one, std::sqrt((1 + doubt) / samples));
  most.kurtosis = 3;
  expect_noise(fmt::format("the noise with {} samples per call, against that with 1, which is "
                           "{:.3g}",
                           samples, noise_of(of_one, 1).deviation.g),
               mean_of(estimates(s, calls, samples)), most);
}

}  // namespace grader::check::direct_lights_inputs
