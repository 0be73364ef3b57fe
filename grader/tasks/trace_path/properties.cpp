#include "grader/property/closed_forms.h"
#include "grader/property/generators.h"
#include "grader/property/property.h"
#include "grader/property/repeat.h"
#include "grader/property/rooms.h"
#include "pt/tasks/trace_path.h"

#include <cmath>

#include <fmt/format.h>

namespace grader {
namespace {

using pt::PathSettings;
using pt::Rgb;
using Direct = PathSettings::Direct;

constexpr int kCases = 12;
constexpr int kCalls = 4000;

// A room, and what is asked of it.
struct Case {
  Room room;
  PathSettings settings;
};

void showValue(const Case& c, std::ostream& out) {
  const PathSettings& s = c.settings;
  showValue(c.room, out);
  out << fmt::format("\nbounces {} to {}, direct light by {}, {} samples of it, survival {}",
                     s.from, s.to, s.direct == Direct::lights ? "lights" : "hemisphere",
                     s.light_samples, s.survival);
}

rc::Gen<Rgb> gray(double low, double high) {
  return rc::gen::map(real(low, high), [](double x) { return pt::gray(x); });
}

rc::Gen<Direct> either_way() { return rc::gen::element(Direct::lights, Direct::hemisphere); }

// Any bounces from .. to within low .. high.
rc::Gen<Case> asked_of(const rc::Gen<Room>& rooms, int low, int high, const rc::Gen<Direct>& direct,
                       const rc::Gen<double>& survival = rc::gen::just(0.7)) {
  return rc::gen::exec([=] {
    PathSettings settings;
    settings.from = *whole(low, high);
    settings.to = *whole(settings.from, high);
    settings.direct = *direct;
    settings.light_samples = *whole(1, 3);
    settings.survival = *survival;
    return Case{*rooms, settings};
  });
}

std::vector<Rgb> estimates(const Case& c, int calls = kCalls) {
  return repeat<pt::trace_path>(calls, draw("seed", sampler_seed()), c.room.scene, c.room.point,
                                c.settings);
}

void expect_estimate(const Case& c) {
  const Rgb expected = c.room.sum(std::max(1, c.settings.from), c.settings.to);
  expect_mean("the mean", mean_of(estimates(c)), expected, 1e-9 * max_channel(expected));
}

// A patch under two rectangles, one that is only in the list of lights and one that is only a
// surface: each way of looking for direct light finds one of them, and another answer.
rc::Gen<Case> under_half_lights() {
  return rc::gen::exec([] {
    Stage stage({});
    const Rectangle left{{-1, 0, 1}, {0, 1, 0}, {1, 0, 0}}, right{{1, 0, 1}, {0, 1, 0}, {1, 0, 0}};
    const Rgb of_left = *color(1, 4), of_right = *color(5, 9);
    stage.rectangle(left, of_left, Body::none).surface(right, {}, of_right);
    const Situation made = stage.patch(*color(0.1, 1), *direction_above()).done();
    Case c{{made.scene, made.point, {{}, made.expected}, made.text}, {}};
    c.settings.direct = *either_way();
    c.settings.light_samples = *whole(1, 8);
    if (c.settings.direct == Direct::hemisphere) {
      c.room.bounce[1] = made.point.albedo * of_right / pt::kPi *
                         cosine_of_polygon(right.corners(), {}, {0, 0, 1});
    }
    return c;
  });
}

PROMISE(trace_path, starts_with_direct_light) {
  for_all([] { expect_estimate(*under_half_lights()); }, kCases);
  for_all(
      [] {
        const Case exact = *asked_of(round_room(gray(0.1, 1)), 1, 1, rc::gen::just(Direct::lights));
        for (const Rgb& one : estimates(exact, 10)) {
          expect_near("each estimate of a point light", one, exact.room.bounce[1],
                      1e-9 * max_channel(exact.room.bounce[1]));
        }
      },
      30);
}

PROMISE(trace_path, takes_the_light_samples_asked_for) {
  for_all(
      [] {
        Case c = *under_half_lights();
        c.settings.light_samples = 1;
        const Mean one = mean_of(estimates(c));
        c.settings.light_samples = 16;
        const Mean many = mean_of(estimates(c));
        const double ratio = many.standard_error.g / one.standard_error.g;
        expect(ratio < 0.35, "16 samples of direct light with a quarter of the noise of one",
               fmt::format("{:.3g} times the noise", ratio));
      },
      4);
}

PROMISE(trace_path, matches_the_furnace) {
  for_all(
      [] {
        Case c = *asked_of(glowing_room(gray(0.2, 0.8)), 1, 5, rc::gen::just(Direct::hemisphere));
        c.settings.from = draw("from bounce", whole(0, 1));
        expect_estimate(c);
      },
      kCases);
}

PROMISE(trace_path, adds_up_the_bounces_asked_for) {
  for_all(
      [] {
        expect_estimate(*asked_of(round_room(gray(0.2, 0.8)), 1, 4, rc::gen::just(Direct::lights)));
      },
      30);
}

// In the closed room only up to .95: without a cap, all paths but those that die go on for ever.
PROMISE(trace_path, does_not_depend_on_survival) {
  for_all(
      [] {
        expect_estimate(*asked_of(round_room(gray(0.2, 0.6)), 1, 4, rc::gen::just(Direct::lights),
                                  real(0.3, 0.95)));
      },
      30);
  for_all(
      [] {
        expect_estimate(*asked_of(sunny_wall(gray(0.2, 0.8)), 2, 5, rc::gen::just(Direct::lights),
                                  rc::gen::element(0.1, 0.3, 1.0)));
      },
      kCases);
}

PROMISE(trace_path, takes_the_first_turn_always) {
  for_all(
      [] {
        Case c = *asked_of(round_room(gray(0.2, 0.8)), 2, 4, rc::gen::just(Direct::lights),
                           real(0.2, 0.9));
        c.settings.from = 2;
        for (const Rgb& one : estimates(c, 200)) {
          expect(max_channel(one) > 0, "light from the second bounce in every estimate",
                 "none: the path ended before it");
        }
      },
      kCases);
}

PROMISE(trace_path, ends_at_the_cap) {
  for_all(
      [] {
        expect_estimate(*asked_of(round_room(gray(0.8, 1)), 1, 4, rc::gen::just(Direct::lights),
                                  real(0.8, 0.95)));
      },
      kCases);
}

PROMISE(trace_path, counts_emission_once) {
  for_all(
      [] {
        Case c = *asked_of(room_around_a_lamp(gray(0.2, 0.8)), 1, 4, either_way());
        c.settings.from = *whole(0, c.settings.from);
        expect_estimate(c);
      },
      24);
}

PROMISE(trace_path, tints_at_each_bounce) {
  for_all(
      [] {
        expect_estimate(
            *asked_of(room_around_a_lamp(color(0, 1)), 2, 4, rc::gen::just(Direct::lights)));
      },
      kCases);
}

PROMISE(trace_path, weighs_by_the_cosine) {
  for_all(
      [] {
        expect_estimate(*asked_of(sunny_wall(gray(0.2, 1)), 2, 4, rc::gen::just(Direct::lights)));
      },
      20);
}

PROMISE(trace_path, follows_the_new_ray) {
  for_all(
      [] {
        Case c = *asked_of(round_room(gray(0.2, 0.8)), 2, 3, rc::gen::just(Direct::lights));
        c.settings.from = 2;
        expect_estimate(c);
      },
      20);
}

// A lone patch under the sky.
PROMISE(trace_path, brings_nothing_from_outside) {
  for_all(
      [] {
        const Case c = *rc::gen::exec([] {
          Stage stage({{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, *point(), *magnitude(1e-2, 1e2)});
          const Situation made =
              stage.sky(*color(0.25, 4)).patch(*color(0.1, 1), *direction_above()).done();
          const rc::Gen<Room> under_the_sky = rc::gen::just(
              Room{made.scene, made.point, std::vector<Rgb>(kMostBounces + 1), made.text});
          return *asked_of(under_the_sky, 2, 5, either_way());
        });
        for (const Rgb& one : estimates(c, 200)) {
          expect_near("each estimate of what bounces twice or more", one, {}, 0);
        }
      },
      kCases);
}

PROMISE(trace_path, stays_finite) {
  // A black room: nothing comes back.
  for_all(
      [] {
        const Case c = *asked_of(round_room(gray(0, 0)), 1, 6, either_way());
        for (const Rgb& one : estimates(c, 50)) expect_near("each estimate", one, {}, 0);
      },
      10);
  // Looked at exactly along the surface.
  for_all(
      [] {
        Case c = *asked_of(room_around_a_lamp(gray(0, 1)), 1, 6, either_way());
        const pt::Frame axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        c.room.point.n = c.room.point.geometric_normal = axes.z;
        c.room.point.frame = axes;
        c.room.point.p = c.room.scene.primitives.spheres[0].center -
                         c.room.scene.primitives.spheres[0].radius * axes.z;
        c.room.point.wo = axes.x;
        for (const Rgb& one : estimates(c, 50)) {
          expect(pt::is_finite(one) && one.r >= 0 && one.g >= 0 && one.b >= 0,
                 "finite estimates, none below 0", show(one));
        }
      },
      10);
}

}  // namespace
}  // namespace grader
