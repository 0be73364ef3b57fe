#pragma once

#include "grader/property/generators.h"
#include "grader/property/property.h"
#include "grader/property/repeat.h"
#include "grader/property/rooms.h"
#include "pt/tasks/trace_path.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

// Rooms, what is asked of them, and how noisy an answer may be.

namespace grader::paths {

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

// Bounces to add up, from .. to.
struct Bounces {
  int from = 1, to = 1;
};

// Any of low .. high.
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

// Up to any of low .. high.
inline rc::Gen<Bounces> bounces_from(int from, int low, int high) {
  return rc::gen::map(whole(low, high), [=](int to) { return Bounces{from, to}; });
}

// By default almost all paths survive: what is wrong with roulette alone is seen where survival is
// what varies. (Not all, or a path without a cap would go on for ever in a closed room.)
inline rc::Gen<Case> asked_of(const rc::Gen<Room>& rooms, const rc::Gen<Bounces>& which,
                              const rc::Gen<double>& survival = rc::gen::just(0.95)) {
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

inline std::vector<Rgb> estimates(const Case& c, int calls) {
  return repeat<pt::trace_path>(calls, c.seed, c.room.scene, c.room.point, c.settings);
}

// The largest that the contract allows: twice that of uniform directions, survival .3 or less. The
// contract of direct light allows noise of its own.
inline Noise allowed_noise(const Case& c) {
  constexpr double kFactor = 2, kDirect = 2;
  return {kFactor *
          deviation(c.room, c.settings, {std::min(0.3, c.settings.survival), 4.0 / 3, kDirect})};
}

// Where few paths find anything, their own spread tells little of the error of their mean: at least
// the error of the usual method is allowed.
inline double error_by_chance(const Case& c, const Mean& got) {
  const Rgb usual = deviation(c.room, c.settings, {c.settings.survival});
  double more = 0;
  for (int channel = 0; channel < 3; ++channel) {
    more = std::max(more, usual[channel] / std::sqrt(got.n) - got.standard_error[channel]);
  }
  return kStandardErrors * more;
}

inline void expect_mean_of(const Case& c, const std::vector<Rgb>& found) {
  const Mean got = mean_of(found);
  const int from = std::max(1, c.settings.from), to = c.settings.to;
  expect_mean("the mean", got, c.room.sum(from, to), allowed_noise(c),
              c.room.precision(from, to) + error_by_chance(c, got));
}

inline void expect_estimate(const Case& c, int calls = kCalls) {
  expect_mean_of(c, estimates(c, calls));
}

// A patch under two rectangles, one that is only in the list of lights and one that is only a
// surface: each way of looking for direct light finds one of them, and another answer.
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

}  // namespace grader::paths
