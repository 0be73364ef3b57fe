#pragma once

#include "grader/check/generators.h"
#include "grader/check/property.h"
#include "grader/check/repeat.h"
#include "grader/check/rooms.h"
#include "grader/check/smooth_shading.h"
#include "pt/tasks/trace_path.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

// Rooms, the settings of a path in them, and the noise that an estimate may have.

namespace grader::check::paths {

using pt::PathSettings;
using pt::Rgb;
using Direct = PathSettings::Direct;

inline constexpr int kCalls = 4000;

struct Case {
  Room room;
  PathSettings settings;
  std::uint64_t seed = 0;
};

inline void showValue(const Case& c, std::ostream& out) {
  const PathSettings& s = c.settings;
  showValue(c.room, out);
  out << fmt::format("\nbounces {} to {}; direct light by {}, samples {}; survival {:.4g}", s.from,
                     s.to, s.direct == Direct::lights ? "lights" : "hemisphere", s.light_samples,
                     s.survival);
}

// The bounces to add up, from .. to.
struct Bounces {
  int from = 1, to = 1;
};

// Any range of bounces within low .. high.
inline rc::Gen<Bounces> bounces(int low, int high) {
  return rc::gen::exec([=] {
    const int from = *whole(low, high);
    return Bounces{from, *whole(from, high)};
  });
}

inline rc::Gen<Rgb> gray(double low, double high) {
  return rc::gen::map(real(low, high), [](double x) { return pt::gray(x); });
}

inline rc::Gen<Direct> either_way() { return rc::gen::element(Direct::lights, Direct::hemisphere); }

// The bounces from `from` to any number in low .. high.
inline rc::Gen<Bounces> bounces_from(int from, int low, int high) {
  return rc::gen::map(whole(low, high), [=](int to) { return Bounces{from, to}; });
}

// By default very few paths end by roulette, so that a mistake in roulette breaks only the promises
// that vary survival. (If none ended, a path that ignores the cap would never end.)
inline rc::Gen<Case> asked_of(const rc::Gen<Room>& rooms, const rc::Gen<Bounces>& which,
                              const rc::Gen<double>& survival = rc::gen::just(0.998)) {
  return rc::gen::exec([=] {
    Case c{*rooms, {}, 0};
    const Bounces asked = *which;
    c.settings.from = asked.from;
    c.settings.to = asked.to;
    c.settings.direct = c.room.direct;
    c.settings.light_samples = *whole(1, 3);
    c.settings.survival = *survival;
    c.seed = *sampler_seed();
    return c;
  });
}

// A lamp that fills a twenty-fifth of the hemisphere, weighted by the cosine, found by hemisphere
// sampling.
inline rc::Gen<Room> room_around_a_small_lamp() {
  return room_around_a_lamp(gray(0.3, 0.8), rc::gen::just(Direct::hemisphere), ordinary(),
                            rc::gen::just(0.2));
}

// One bounce of paths that survive rarely, in a room that absorbs almost nothing.
inline rc::Gen<Case> bright_paths(int bounce, double survival) {
  return asked_of(round_room(gray(0.97, 1)), rc::gen::just(Bounces{bounce, bounce}),
                  rc::gen::just(survival));
}

// Paths that may end before each bounce, in a room in which the direction of the bounce decides what
// light is found.
inline rc::Gen<Case> mortal_paths_around_a_lamp() {
  return asked_of(room_around_a_lamp(gray(0.3, 0.6), rc::gen::just(Direct::lights)),
                  rc::gen::just(Bounces{3, 3}), real(0.3, 0.5));
}

// A point light of intensity 1e6 in a room of radius 1e-3.
inline Ranges brightest() {
  Ranges ranges = ordinary();
  ranges.size = 1e3;
  ranges.light = rc::gen::map(color(0.25, 1), [](Rgb light) { return 1e12 * light; });
  ranges.small = true;
  return ranges;
}

// A wall that glows and reflects the light of one or two suns. It is not in the list
// of lights, so that its own light does not count.
inline rc::Gen<Room> glowing_wall_in_the_sun() {
  return rc::gen::map(sunny_wall(gray(0.2, 1)), [](Room room) {
    for (pt::Material& material : room.scene.materials) material.emission = pt::gray(3);
    room.text += "the wall glows\n";
    return room;
  });
}

// A wall in the sun above a point that is shaded smoothly or not.
inline rc::Gen<Room> wall_above_any_normal() {
  return rc::gen::exec([] {
    Room room = *sunny_wall(gray(0.2, 1));
    if (*rc::gen::arbitrary<bool>()) room.point = smoothly_shaded(room.point);
    return room;
  });
}

// For a surface seen from straight above, the mock diffuse_sample draws uniform directions
// (grader/check/mock_diffuse_bsdf.cpp).
inline rc::Gen<Case> seen_from_straight_above() {
  return rc::gen::exec([] {
    Case made = *asked_of(sunny_wall(gray(0.2, 1), 0.3), bounces(2, 2));
    made.room.point.wo = made.room.point.n;
    return made;
  });
}

// One channel is bright everywhere, so that roulette by the throughput keeps enough paths. One is
// black.
inline rc::Gen<Case> tinted(int bright, int black, const rc::Gen<Bounces>& which) {
  const rc::Gen<Rgb> tint = rc::gen::map(color(0, 1), [=](Rgb albedo) {
    albedo[bright] = 0.3 + 0.7 * albedo[bright];
    if (black != bright) albedo[black] = 0;
    return albedo;
  });
  return asked_of(room_around_a_lamp(tint, rc::gen::just(Direct::lights)), which);
}

// A point that is seen at a grazing angle. In some channels, or in all, nothing is reflected.
inline rc::Gen<Case> grazed_and_black() {
  return rc::gen::exec([] {
    const bool all = *rc::gen::element(true, false, false, false);
    const int black = *whole(0, 2);
    const rc::Gen<Rgb> some_black = rc::gen::map(color(0.3, 0.8), [=](Rgb albedo) {
      if (all) return Rgb{};
      albedo[black] = 0;
      return albedo;
    });
    const rc::Gen<Bounces> which = rc::gen::exec([] {
      return Bounces{*whole(1, 2), *whole(2, 6)};
    });
    Case made = *asked_of(room_around_a_lamp(some_black, either_way()), which);
    const double z = *magnitude(1e-8, 0.1);
    const pt::Vec3 wo{std::sqrt(1 - z * z), 0, z};
    made.room.point.wo = made.room.point.frame.to_world(wo);
    return made;
  });
}

inline std::vector<Rgb> estimates(const Case& c, int calls) {
  return repeat<pt::trace_path>(calls, c.seed, c.room.scene, c.room.point, c.settings);
}

// The largest noise that the contract allows: twice the noise with a survival of .3 or less, and
// with inner tasks that are as noisy as their contracts allow.
inline Noise allowed_noise(const Case& c) {
  return {2 * deviation(c.room, c.settings, {std::min(0.3, c.settings.survival), 2, 2})};
}

// If only few paths find light, their spread does not show the error of their mean. So at least the
// error of the usual method is allowed. `mean_square` is that of its diffuse_sample
// (grader/check/rooms.h).
inline double error_by_chance(const Case& c, const Mean& got, double mean_square) {
  const Rgb usual = deviation(c.room, c.settings, {c.settings.survival, mean_square});
  double more = 0;
  for (int channel = 0; channel < 3; ++channel) {
    more = std::max(more, usual[channel] / std::sqrt(got.n) - got.standard_error[channel]);
  }
  return kStandardErrors * more;
}

inline void expect_mean_of(const Case& c, const std::vector<Rgb>& found, double mean_square = 1) {
  const Mean got = mean_of(found);
  const int from = std::max(1, c.settings.from), to = c.settings.to;
  expect_mean("the mean", got, c.room.sum(from, to), allowed_noise(c),
              c.room.precision(from, to) + error_by_chance(c, got, mean_square));
}

inline void expect_estimate(const Case& c, int calls = kCalls) {
  expect_mean_of(c, estimates(c, calls));
}

// Returns how many estimates are not black.
inline int lit_among(const std::vector<Rgb>& all) {
  return static_cast<int>(
      std::count_if(all.begin(), all.end(), [](const Rgb& one) { return max_channel(one) > 0; }));
}

// The same of `calls` estimates of bounce k alone.
inline int lit(Case c, int k, int calls) {
  c.settings.from = c.settings.to = k;
  return lit_among(estimates(c, calls));
}

// Returns the mean square of the estimates of bounce k alone.
inline double mean_square(Case c, int k, int calls) {
  c.settings.from = c.settings.to = k;
  double sum = 0;
  for (const Rgb& one : estimates(c, calls)) sum += one.g * one.g;
  return sum / calls;
}

// Returns what the variance of bounce `to` alone will be, as a multiple of its squared mean, in a
// furnace of `albedo`. Each bounce multiplies the estimate by a weight f cos / pdf of the
// solution's own diffuse_sample. The weights of different bounces are independent, so each bounce
// multiplies the mean square by the same factor: albedo^2 for directions in proportion to the
// cosine, 4/3 albedo^2 for uniform ones. Then bounce 30 would need millions of estimates, because
// few of them have nearly all the light. The factor is found from bounces 2 and 6 of paths of which
// few end.
inline double relative_variance_far_along(Case c) {
  constexpr int kNear = 2, kBeyond = 6;
  c.settings.survival = 0.998;
  const double albedo = c.room.point.albedo.g;
  const double grown = mean_square(c, kBeyond, kCalls) / mean_square(c, kNear, kCalls);
  const double each = std::pow(grown, 1.0 / (kBeyond - kNear)) / (albedo * albedo);
  return std::pow(each, c.settings.to) - 1;
}

}  // namespace grader::check::paths
