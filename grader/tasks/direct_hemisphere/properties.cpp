#include "grader/check/generators/directions_found.h"
#include "grader/check/generators/generators.h"
#include "grader/check/generators/random_numbers.h"
#include "grader/check/language/in_a_row.h"
#include "grader/check/language/property.h"
#include "grader/check/language/repeat.h"
#include "grader/check/language/repetition.h"
#include "grader/check/language/two_numbers.h"
#include "grader/check/scenes/closed_forms.h"
#include "grader/check/scenes/in_turn.h"
#include "grader/check/scenes/scenes.h"
#include "grader/check/scenes/textbook.h"
#include "grader/tasks/direct_hemisphere/inputs.h"
#include "grader/tasks/direct_hemisphere/wild.h"
#include "pt/tasks/direct_hemisphere.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace grader::check {
namespace {

using namespace direct_hemisphere_inputs;
using pt::Rgb;
using pt::Vec3;

constexpr int kCases = 9;

// The error that the contract allows in addition to noise: 1e-5 of the value for the task, and the
// same for diffuse_f, which the task may call.
double tolerance(const Situation& s) { return 2 * kColorPrecision * max_channel(s.expected); }

std::vector<Rgb> estimates(const Situation& s, int calls, int samples) {
  return repeat<pt::direct_hemisphere>(calls, draw("seed", sampler_seed()), s.scene, s.point,
                                       samples);
}

// Fewer samples per call make more calls, so that all cases draw about as many directions.
int calls_of(int samples) { return std::clamp(18000 / samples, 100, 3000); }

void expect_estimate(const Situation& s, int samples) {
  expect_mean(fmt::format("the mean, {} samples per call", samples),
              mean_of(estimates(s, calls_of(samples), samples)), s.expected,
              noise_of_directions(s, samples), tolerance(s));
}

void expect_estimate(const Situation& s) {
  expect_estimate(s, draw("samples per call", rc::gen::element(1, 2, 3, 5, 16, 17)));
}

// The same in a scene that asks nothing of the directions which others do not.
void expect_light(const Situation& s, int samples) {
  if (!needs_no_mean(s, samples)) expect_estimate(s, samples);
}
void expect_light(const Situation& s) {
  expect_light(s, draw("samples per call", rc::gen::element(1, 2, 3, 5, 16, 17)));
}

// Every single estimate must be black.
void expect_dark(const Situation& s) {
  if (needs_no_mean(s, 1)) return;
  for (const Rgb& one : estimates(s, 4000, 1)) expect_near("each estimate", one, {}, 0);
}

PROMISE(direct_hemisphere, sees_the_sky) {
  for_all([] { expect_estimate(*under_the_sky()); }, kCases);
}

PROMISE(direct_hemisphere, sees_a_light_of_known_size) {
  for_all([] { expect_estimate(*under_a_rectangle(unturned_pose(), rc::gen::just(0.0))); }, kCases);
  for (const double size : {1e-6, 1e6}) {
    for_all([=] { expect_estimate(*far_below_a_rectangle(size), 16); }, 1);
  }
  for_all([] { expect_estimate(*under_a_ball()); }, 3);
}

PROMISE(direct_hemisphere, sees_lights_of_any_brightness) {
  for (const bool sky : {false, true}) {
    for (const auto& bright : {rc::gen::just(1e-4), rc::gen::just(1e6), brightness()}) {
      for_all(
          [&] {
            expect_light(*patch_with([&](SceneMaker& maker) {
              const Rgb radiance = *bright * any_radiance();
              sky ? maker.sky(radiance)
                  : maker.rectangle(*rectangle_above(0.9, 1.6, 2.5), radiance, Body::surface);
            }));
          },
          2);
      if (testing::Test::HasFailure()) return;
    }
  }
}

// The glowing surface is not in the list of lights, and the lights in the list have no surface.
PROMISE(direct_hemisphere, takes_the_emission_of_what_is_hit) {
  for_all([] { expect_light(*beside_lights_without_surfaces()); }, kCases);
  expect_explained(wild_task());
}

PROMISE(direct_hemisphere, adds_no_emission_of_its_own) {
  for_all(
      [] {
        expect_dark(*glowing_patch_with(
            [](SceneMaker& maker) { maker.surface(*rectangle_above(1, 0.5, 2), *color()); }));
      },
      5);
  for_all([] { expect_light(*glowing_patch_with(lamp)); }, 5);
}

PROMISE(direct_hemisphere, sees_what_is_in_the_way) {
  for_all([] { expect_light(*under_a_rectangle(unturned_pose(), real(0.3, 0.6))); }, kCases);
  for_all([] { expect_dark(*under_a_rectangle(unturned_pose(), rc::gen::just(1.0))); }, 5);
  for_all([] { expect_dark(*behind_the_back_of_a_surface()); }, 1);
  for_all([] { expect_light(*before_a_wall()); }, 5);
}

// The order of the corners says which side is bright. Corner normals may be on the other side.
PROMISE(direct_hemisphere, sees_only_the_bright_side) {
  for_all([] { expect_dark(*under_one_side_of_a_light(Side::dark)); }, 5);
  for_all([] { expect_light(*under_one_side_of_a_light(Side::bright)); }, 5);
  const auto turned_round = [](Side side) {
    return rc::gen::map(under_one_side_of_a_light(side), with_corner_normals_turned_round);
  };
  for_all([] { expect_light(*under_front_and_back_of_a_material(), 16); }, 3);
  for_all([&] { expect_dark(*turned_round(Side::dark)); }, 1);
  for_all([&] { expect_light(*turned_round(Side::bright)); }, 1);
}

PROMISE(direct_hemisphere, works_in_every_orientation) {
  for_all([] { expect_estimate(*under_a_rectangle(pose(), rc::gen::just(0.0))); }, 9);
  // The normal is exactly an axis of the world: a level floor, a ceiling, four walls.
  for (const Vec3 n : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    for (const Vec3 normal : {n, -n}) {
      for_all([&] { expect_estimate(*under_a_rectangle(pose_on(normal), rc::gen::just(0.0))); }, 1);
    }
  }
  for_all([] { expect_estimate(*smoothly_shaded_under_a_lamp()); }, 8);
}

PROMISE(direct_hemisphere, looks_from_the_side_it_is_seen_on) {
  for_all([] { expect_light(*patch_with(lamp, unturned_pose(), true)); }, kCases);
}

PROMISE(direct_hemisphere, reflects_the_albedo) {
  for_all(
      [] {
        Situation s = *patch_with([](SceneMaker& maker) {
          maker.rectangle(*rectangle_above(0.9, 1.6, 2.5), *hue() * any_radiance(), Body::surface);
        });
        for (int channel = 0; channel < 3; ++channel) {
          s.expected[channel] /= s.point.albedo[channel];
          s.point.albedo[channel] = draw(fmt::format("but its albedo in {}", kChannels[channel]),
                                         rc::gen::element(0.0, 0.001, 0.5, 0.999, 1.0));
          s.expected[channel] *= s.point.albedo[channel];
        }
        expect_light(s);
      },
      kCases);
  // A surface that is dark in all channels is not black.
  for_all(
      [] {
        Situation s = *patch_with(lamp);
        const double part = draw("but its albedo times", magnitude(1e-8, 1e-3));
        s.point.albedo *= part;
        s.expected *= part;
        expect_light(s, 16);
      },
      3);
  // A surface that absorbs nothing.
  for_all(
      [] {
        Situation s = *patch_with(lamp);
        for (int channel = 0; channel < 3; ++channel) {
          s.expected[channel] /= s.point.albedo[channel];
        }
        s.point.albedo = pt::gray(1);
        expect_light(s, 16);
      },
      1);
}

// In a room that glows everywhere, one direction gives 2 albedo L cos, and cos is uniform. Relative
// to the squared mean, this is a variance of 1/3, and of 5/3 where one half of the room is dark. The
// mean of n directions has 1/n of it; stratified directions have even less.
Noise noise_of_two_halves(const Situation& s, int samples) {
  const Rgb relative{std::sqrt(1.0 / 3), std::sqrt(5.0 / 3), std::sqrt(5.0 / 3)};
  return {s.expected * relative / std::sqrt(samples), 3};
}

PROMISE(direct_hemisphere, takes_the_samples_asked_for) {
  const auto expect_mean_and_noise = [](const Situation& s, int samples, int calls) {
    expect_mean(fmt::format("the mean, {} samples per call", samples),
                mean_of(estimates(s, calls, samples)), s.expected, noise_of_two_halves(s, samples),
                tolerance(s));
  };
  // The record of a call shows how many directions it took.
  const auto expect_samples = [&](int samples, int calls) {
    const Situation s = *in_a_room_of_two_halves(pose(1));
    if (!needs_no_mean(s, samples)) expect_mean_and_noise(s, samples, calls);
  };
  for_all(
      [&] {
        const int samples = draw("samples per call", rc::gen::element(1, 2, 3, 7, 16, 33));
        expect_samples(samples, calls_of(samples));
      },
      6);
  // Directions that share a random number, two and two, have up to twice the variance.
  for (const auto& many : {whole(17, 64), whole(65, 300), whole(301, 600)}) {
    for_all(
        [&] {
          const Situation s = *in_a_room_of_two_halves(pose(1));
          expect_mean_and_noise(s, draw("samples per call", many), 300);
        },
        1);
  }
  // There are so many calls that one missing or extra sample in 64 shows in the mean.
  for_all([&] { expect_samples(64, 2500); }, 1);
  // Many dark directions in a row say nothing about the next one.
  for_all([&] { expect_estimate(*under_a_small_lamp(), 1000); }, 1);
  // The noise of this many samples shows a hidden maximum.
  for_all([&] { expect_samples(4000, 100); }, 1);
  // A counter of two bytes leaves one of these samples. By chance, the mean of so many is off by seven of
  // its deviations less than once in a hundred billion times.
  for_all(
      [] {
        constexpr int kMost = 65537;
        const Situation s = *in_a_glowing_room(pose(1));
        const double off = 7 / std::sqrt(3.0 * kMost) * max_channel(s.expected) + tolerance(s);
        for (const Rgb& one : estimates(s, 3, kMost)) {
          expect_near(fmt::format("each estimate of {} samples", kMost), one, s.expected, 2 * off);
        }
      },
      1);
  expect_explained(wild_task());
}

PROMISE(direct_hemisphere, starts_off_the_surface) {
  // Small and large scenes, close to the world's origin and far from it.
  const auto anywhere = [] { return rc::gen::oneOf(pose(1e6), pose(1e6, 1e4)); };
  for_all(
      [&] {
        const bool smooth = *rc::gen::element(false, false, true);
        const Situation s =
            smooth ? *smooth_point_in_a_glowing_room() : *in_a_glowing_room(anywhere());
        Rgb sum{};
        for (const Rgb& one : estimates(s, 200, 1)) {
          expect(max_channel(one) > 0, "light from every direction",
                 "an estimate of 0: perhaps the ray met the surface that it started on, or ended "
                 "before the walls");
          sum += one;
        }
        // Other promises judge the mean. Here, a constant close to 0 fails.
        expect(max_channel(sum) / 200 > 0.02 * max_channel(s.expected),
               "light from the walls in most estimates", "hardly any");
      },
      60);
  for_all(
      [&] {
        for (const Rgb& one : estimates(*under_a_lid(anywhere()), 50, 1)) {
          expect(max_channel(one) < 0.01, "no light through a lid close to the surface",
                 brief(one));
        }
      },
      60);
}

// Each piece of the room has its own hue, which shows where a direction went.
void expect_even(const std::vector<Rectangle>& pieces, int calls, bool smooth = false) {
  const Situation s = *in_a_colored_room(pieces, smooth);
  const std::vector<Rgb> draws = estimates(s, calls, 1);
  std::vector<DirectionCell> cells;
  for (const Rectangle& piece : pieces) {
    const std::vector<Vec3> c = piece.corners();
    const double share = solid_angle(c[0], c[1], c[2], {}) + solid_angle(c[0], c[2], c[3], {});
    cells.push_back(
        {normalize(piece.center), 0, share / (2 * pt::kPi) * static_cast<double>(draws.size())});
  }
  for (const Rgb& draw : draws) {
    const double cell = std::round(draw.g / draw.r) - 1;
    if (cell >= 0 && cell < static_cast<double>(cells.size())) {
      ++cells[static_cast<std::size_t>(cell)].found;
    }
  }
  expect_spread(cells);
}

// The estimate gives the height of its direction, and its hue the azimuth. Within a strip, any azimuth
// may stand for that of the direction.
void expect_independent_angles() {
  constexpr int kStrips = 1024, kDirections = 1500;
  const Situation s = *in_a_colored_room(strips_all_around(kStrips));
  RandomNumbers within(draw("seed", sampler_seed()));
  std::vector<NumberPair> pairs;
  for (const Rgb& one : estimates(s, kDirections, 1)) {
    if (!(one.r > 0)) continue;  // it went above the strips
    const double height = one.r / (2 * s.point.albedo.r), strip = std::round(one.g / one.r) - 1;
    pairs.push_back({height, (strip + within.between(0, 1)) / kStrips});
  }
  expect(pairs.size() > kDirections / 2, "directions up to 76 degrees above the horizon", "few");
  expect_two_numbers("the height of a direction and its angle around the normal", pairs);
}

// Numbers that are hardly ever drawn: the ends of [0, 1), and one that a float rounds to 1. If half of the
// directions are well above the surface with a number close by, some are with the rare one. The chance
// that all forty are not is less than one in a hundred million.
void expect_light_at_a_rare_number(double xi, int place) {
  constexpr int kTried = 40;
  const Situation s = *in_a_glowing_room(pose(1));
  const auto seed = draw("seed", sampler_seed());
  // Returns how many estimates have more light than `least`.
  const auto brighter_at = [&](double number, double least) {
    int brighter = 0;
    for (int i = 0; i < kTried; ++i) {
      pt::Sampler sampler = sampler_that_draws(number, place, seed + i);
      const Rgb one = pt::direct_hemisphere(s.scene, s.point, 1, sampler);
      expect(pt::is_finite(one), "a finite estimate whatever the random numbers are", show(one));
      brighter += max_channel(one) > least;
    }
    return brighter;
  };
  const int with_it = brighter_at(xi, 0);
  const double close_by = xi < 0.5 ? 1e-6 : 1 - 1e-6;
  if (brighter_at(close_by, 0.5 * max_channel(s.expected)) < kTried / 2) return;
  expect(with_it > 0, "light from everywhere, whatever the random numbers are",
         fmt::format("none in {} estimates, if random number {} is {}", kTried, place + 1, xi));
}

PROMISE(direct_hemisphere, spreads_evenly_over_the_hemisphere) {
  for_all([] { expect_even(dome(6), 6000); }, 3);
  for_all([] { expect_even(dome(6), 6000, true); }, 1);
  for_all([] { expect_even(*rc::gen::exec(narrow_strips), 12000); }, 1);
  for_all(expect_independent_angles, 1);
  for (int place = 0; place < 4; ++place) {
    for (const double xi : {0.0, 1 - 0x1p-53, 1 - 0x1p-26}) {
      for_all([=] { expect_light_at_a_rare_number(xi, place); }, 1);
    }
  }
  // A bright strip at the horizon, less than a tenth of a degree high. About 50 directions meet it.
  for_all(
      [] {
        const Situation s = *in_a_room_lit_at_the_horizon();
        const Mean mean = mean_of(estimates(s, 300, 200));
        const double part = mean.value.g / s.expected.g;
        expect(part > 0.2, "light from a strip at the horizon, seen by 50 directions in 60000",
               fmt::format("{:.3g} times its light", part));
      },
      1);
}

// Estimates of many directions repeat each other if only few seeds are behind them.
void expect_different(const std::vector<Rgb>& answers) {
  std::vector<double> red;
  for (const Rgb& answer : answers) red.push_back(answer.r);
  const Repetition found = repetition(red);
  expect(!found.half_are_repeated(), fmt::format("{} different estimates", found.all),
         fmt::format("only {} different ones", found.different));
}

PROMISE(direct_hemisphere, draws_from_the_sampler_alone) {
  for (const auto& few_or_many : {rc::gen::just(1), whole(2, 33), whole(65, 130)}) {
    for_all(
        [&] {
          const Situation s = *in_a_room_of_two_halves(unturned_pose());
          const int samples = draw("samples per call", few_or_many);
          const auto answers =
              expect_goes_on(draw("seed", sampler_seed()), [&](pt::Sampler& sampler) {
                return pt::direct_hemisphere(s.scene, s.point, samples, sampler);
              });
          expect_mean("the mean of calls in a row", mean_of(answers), s.expected,
                      noise_of_two_halves(s, samples), tolerance(s));
          expect_different(answers);
        },
        1);
  }
  // Few directions meet this lamp, and most calls of one sample find no light.
  for_all(
      [] {
        const Situation s = *under_a_small_lamp();
        expect_moves_on(draw("seed", sampler_seed()), [&](pt::Sampler& sampler) {
          return pt::direct_hemisphere(s.scene, s.point, 1, sampler);
        });
      },
      4);
  for_all(
      [] {
        constexpr int kTurns = 20, kSamples = 64;
        const auto [before, now] = *under_the_sky_in_turn();
        const auto seed = draw("seed", sampler_seed());
        std::vector<Rgb> of_before, of_now;
        for (int i = 0; i < kTurns; ++i) {
          const auto ask = [&](const Situation& s) {
            return repeat<pt::direct_hemisphere>(1, seed + i, s.scene, s.point, kSamples).front();
          };
          of_before.push_back(ask(before));
          of_now.push_back(ask(now));
        }
        const auto expect_of = [](const std::vector<Rgb>& answers, const Situation& s) {
          expect_mean("the mean of every second call, between calls with other numbers",
                      mean_of(answers), s.expected, noise_of_directions(s, kSamples), tolerance(s));
        };
        expect_of(of_before, before);
        expect_of(of_now, now);
      },
      20);
  expect_explained(wild_task());
}

}  // namespace
}  // namespace grader::check
