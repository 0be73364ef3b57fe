#include "grader/check/generators/random_numbers.h"
#include "grader/check/language/in_a_row.h"
#include "grader/check/scenes/in_turn.h"
#include "grader/tasks/trace_path/estimates.h"
#include "grader/tasks/trace_path/inputs.h"
#include "grader/tasks/trace_path/wild.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace grader::check {
namespace {

using namespace trace_path_inputs;

constexpr int kCases = 12;

PROMISE(trace_path, starts_with_direct_light) {
  for_all(
      [] {
        const HalfLights c = *under_half_lights(either_way());
        if (needs_no_mean(c, c.settings.light_samples)) return;
        expect_mean("the mean", mean_of(estimates(c, c.settings.light_samples)), c.expected,
                    noise_of_half_lights(c), 4 * kColorPrecision * max_channel(c.expected));
      },
      kCases);
  for_all(
      [] {
        const Case exact = *asked_of(round_room(gray(0.1, 1)), bounces(1, 1), rc::gen::just(0.5));
        const Rgb direct = exact.room.sum(1, 1);
        for (const Rgb& one : estimates(exact, 10)) {
          expect_near("each estimate of a point light", one, direct, exact.room.precision(1, 1));
        }
      },
      30);
  // Light that only the other way of sampling would find.
  const auto expect_none = [](Case c, Direct direct) {
    c.settings.direct = direct;
    for (const Rgb& one : estimates(c, 20)) {
      expect_near("each estimate, where the way asked for finds no light", one, {}, 0);
    }
  };
  for_all(
      [&] { expect_none(*asked_of(glowing_room(gray(0.3, 0.8)), bounces(1, 3)), Direct::lights); },
      3);
  for_all(
      [&] {
        expect_none(*asked_of(round_room(gray(0.3, 0.8)), bounces(1, 3)), Direct::hemisphere);
      },
      3);
  expect_explained(wild_task());
}

// Returns whether bounce 2 is about right in a room that glows everywhere, with few light samples. If it is
// not, other promises say so.
bool is_right_at_the_second_bounce() {
  bool is_right = false;
  for_all(
      [&] {
        const Case c = *asked_of(glowing_room(gray(0.3, 0.8)), rc::gen::just(Bounces{2, 2}));
        is_right = needs_no_mean(c);
        if (is_right) return;
        const double expected = c.room.sum(2, 2).g;
        is_right = std::abs(mean_of(estimates(c, 1000)).value.g - expected) < 0.2 * expected;
      },
      1);
  return is_right;
}

PROMISE(trace_path, takes_the_light_samples_asked_for) {
  for (const Direct direct : {Direct::lights, Direct::hemisphere}) {
    for_all([=] { expect_a_tenth_of_the_noise(*under_half_lights(rc::gen::just(direct))); }, 1);
  }
  if (!is_right_at_the_second_bounce()) return;
  // At the second bounce, the contract allows more noise. Few directions meet such a small lamp, so
  // that one sample has even more noise.
  for_all(
      [] {
        const auto with_many_samples = [](Case c) {
          c.settings.light_samples = 100;
          return c;
        };
        const auto cases = asked_of(room_around_a_small_lamp(), rc::gen::just(Bounces{2, 2}));
        expect_estimate(*rc::gen::map(cases, with_many_samples), 2 * kCalls);
      },
      1);
  expect_explained(wild_task());
}

// Bounces far along the path. If roulette of the solution's own ends most paths before, or if the weights
// of its diffuse_sample vary much, their mean cannot be judged.
void expect_estimate_far_along(const Case& c) {
  if (needs_no_mean(c)) return;
  const std::vector<Rgb> found = estimates(c, 2000);
  constexpr double kMaxVariance = 15;
  if (lit_among(found) > 1000 && relative_variance_far_along(c) < kMaxVariance) {
    expect_mean_of(c, found);
  }
}

PROMISE(trace_path, matches_the_furnace) {
  for_all(
      [] {
        const rc::Gen<Bounces> all = rc::gen::exec([] {
          return Bounces{*whole(0, 1), *whole(1, 5)};
        });
        expect_estimate(*asked_of(glowing_room(gray(0.3, 0.8)), all));
      },
      kCases);
  for_all(
      [] {
        const rc::Gen<Bounces> far = rc::gen::map(rc::gen::element(8, 15, 30), [](int bounce) {
          return Bounces{bounce, bounce};
        });
        expect_estimate_far_along(*asked_of(glowing_room(gray(0.7, 1)), far));
      },
      4);
}

PROMISE(trace_path, adds_up_the_bounces_asked_for) {
  for_all([] { expect_estimate(*asked_of(round_room(gray(0.3, 0.8)), bounces(1, 4))); }, 30);
  for_all(
      [] {
        const rc::Gen<Bounces> many = rc::gen::exec([] {
          return Bounces{*whole(0, 2), *rc::gen::element(0, 8, 30, 100)};
        });
        expect_estimate(*asked_of(round_room(gray(0.1, 0.35)), many), 1000);
      },
      kCases);
  for_all(
      [] {
        const rc::Gen<Bounces> none = rc::gen::exec([] {
          const int to = *rc::gen::element(0, 1, 2, 8, 99);
          return Bounces{*whole(to + 1, 100), to};
        });
        for (const Rgb& one : estimates(*asked_of(round_room(gray(0.3, 0.8)), none), 50)) {
          expect_near("each estimate where no bounce is asked for", one, {}, 0);
        }
      },
      kCases);
  expect_explained(wild_task());
}

PROMISE(trace_path, does_not_depend_on_survival) {
  for_all(
      [] {
        expect_estimate(*asked_of(closed_room(gray(0.3, 0.6)), bounces(1, 4), real(0.3, 0.95)));
      },
      26);
  for_all([] { expect_estimate(*mortal_paths_around_a_lamp(Direct::lights)); }, 4);
  for_all([] { expect_estimate(*mortal_paths_around_a_lamp(Direct::hemisphere), 2 * kCalls); }, 6);
  for_all([] { expect_estimate(*mortal_paths_in(dented_room(gray(0.7, 1))), 2 * kCalls); }, 4);
  for_all([] { expect_estimate(*mortal_paths_in(smooth_wall_in_a_hall()), 6 * kCalls); }, 6);
  for_all([] { expect_estimate_far_along(*mortal_paths_far_along()); }, 4);
  for_all(
      [] {
        expect_estimate(
            *asked_of(closed_room(gray(0.3, 0.8)), bounces(2, 3), rc::gen::element(0.05, 0.1, 1.0)),
            2 * kCalls);
      },
      kCases);
  // A path that survives is worth 20 paths, and almost nothing is absorbed. The error by chance is
  // that with the noisiest diffuse_sample that its contract allows.
  constexpr int kMany = 40000;
  for_all(
      [] {
        const Case c = *bright_paths(3, 0.05);
        expect_mean_of(c, estimates(c, kMany), 2);
      },
      1);
  // A path that survives twice is worth 400. Some hundred of these paths are too few to judge the
  // mean if the weights of the solution's own diffuse_sample vary.
  for_all(
      [] {
        const Case c = *bright_paths(4, 0.05);
        if (relative_variance_far_along(c) < 0.3) expect_mean_of(c, estimates(c, kMany));
      },
      1);
}

// At most `dark` of the estimates may have no light from the second bounce.
void expect_light_in_all(const Case& c, int calls, int dark) {
  const std::vector<Rgb> found = estimates(c, calls);
  const auto ended = std::ranges::count_if(found, [](Rgb one) { return !(max_channel(one) > 0); });
  expect(ended <= dark, "light from the second bounce in every estimate",
         fmt::format("none in {} of {} estimates: the path ended before it", ended, calls));
  expect_mean_of(c, found);
}

PROMISE(trace_path, takes_the_first_bounce_always) {
  for_all(
      [] {
        const Case c = *asked_of(round_room(gray(0.2, 0.8)), bounces(2, 2), real(0.05, 0.9));
        expect_light_in_all(c, 1000, 0);
      },
      kCases);
  // So many that some ten go almost along the surface. One of 2^25 random numbers is 1 in float, and its
  // path may go along it and end.
  for_all(
      [] {
        expect_light_in_all(*asked_of(round_room(gray(0.2, 0.8)), rc::gen::just(Bounces{2, 2})),
                            100000, 1);
      },
      1);
  expect_explained(wild_task());
}

PROMISE(trace_path, stops_after_the_last_bounce) {
  for_all(
      [] { expect_estimate(*asked_of(closed_room(gray(0.8, 1)), bounces(1, 4), real(0.8, 0.95))); },
      kCases);
}

// If half of the paths go on with a random number close to 1, some go on with one that a float rounds to
// 1. The chance that all forty end is less than one in a hundred million.
void expect_light_at_the_largest_number(int place) {
  constexpr int kTried = 40;
  const Case c =
      *asked_of(round_room(gray(0.5, 1)), rc::gen::just(Bounces{3, 3}), rc::gen::just(1.0));
  const auto lit_at = [&](double xi) {
    std::vector<Rgb> found;
    for (int i = 0; i < kTried; ++i) {
      pt::Sampler sampler = sampler_that_draws(xi, place, c.seed + i);
      found.push_back(pt::trace_path(c.room.scene, c.room.point, c.settings, sampler));
    }
    return lit_among(found);
  };
  if (lit_at(1 - 1e-6) < kTried / 2) return;
  expect(
      lit_at(1 - 0x1p-26) > 0, "paths that go on, with survival 1",
      fmt::format("none, if random number {} is so large that a float rounds it to 1", place + 1));
}

PROMISE(trace_path, reaches_the_last_bounce) {
  for (int place = 0; place < 8; ++place) {
    for_all([=] { expect_light_at_the_largest_number(place); }, 1);
  }
  for_all(
      [] {
        const Case c = *far_along();
        if (needs_no_mean(c)) return;
        const Reach reach = reach_of(c);
        if (reach.last == c.settings.to) return;
        expect(
            lit(c, reach.beyond, kPaths) > 0,
            fmt::format("some paths that go on after bounce {}, because many reach it", reach.last),
            fmt::format("none of {} that brings light of bounce {}", kPaths, reach.beyond));
      },
      8);
  // All paths of this scene leave it after the second bounce, so that none reaches bounce 3.
  for_all(
      [] {
        const Case c = *asked_of(sunny_wall(gray(0.2, 1)), bounces_from(3, 3, 100));
        expect(lit(c, 3, kPaths) == 0, "a path that leaves the scene ends there",
               "light of bounce 3 in a scene without one");
      },
      8);
  expect_explained(wild_task());
}

PROMISE(trace_path, counts_emission_once) {
  for_all(
      [] {
        const rc::Gen<Bounces> which = rc::gen::exec([] {
          const Bounces some = *bounces(1, 4);
          return Bounces{*whole(0, some.from), some.to};
        });
        expect_estimate(*asked_of(room_around_a_lamp(gray(0.3, 0.8), either_way()), which));
      },
      20);
  // A surface that glows reflects light, too.
  for_all([] { expect_estimate(*asked_of(glowing_wall_in_the_sun(), bounces(2, 2))); }, 4);
}

PROMISE(trace_path, tints_at_each_bounce) {
  for_all(
      [] {
        const int bright = *whole(0, 2);
        expect_estimate(*tinted(bright, bright, bounces(2, 4)));
      },
      9);
  for_all([] { expect_estimate(*in_a_dark_room(), 1000); }, 4);
  for (int black = 0; black < 3; ++black) {
    for_all(
        [=] {
          expect_estimate(*tinted((black + 1) % 3, black, rc::gen::just(Bounces{3, 3})));
        },
        1);
  }
}

PROMISE(trace_path, weighs_by_the_cosine) {
  for_all([] { expect_estimate(*asked_of(sunny_wall(gray(0.2, 1)), bounces(2, 2))); }, 10);
  for_all([] { expect_estimate(*asked_of(wall_above_a_smooth_point(), bounces(2, 2))); }, 40);
  for_all(
      [] {
        expect_estimate(*asked_of(wall_under_the_sky(color(0.1, 1), either_way(), true),
                                  bounces_from(2, 2, 3)));
      },
      10);
}

PROMISE(trace_path, divides_by_the_pdf_of_the_sample) {
  for_all([] { expect_estimate(*seen_from_straight_above()); }, kCases);
  for_all([] { expect_estimate(*bright_and_seen_from_straight_above()); }, 4);
}

PROMISE(trace_path, follows_the_new_ray) {
  for_all([] { expect_estimate(*asked_of(round_room(gray(0.3, 0.8)), bounces(2, 3))); }, 20);
  for_all(
      [] {
        expect_estimate(
            *asked_of(glowing_room_around_a_smooth_point(), rc::gen::just(Bounces{2, 2})));
      },
      6);
  for_all([] { expect_estimate(*asked_of(smooth_wall_in_a_hall(), bounces(3, 3))); }, 8);
  for_all([] { expect_estimate(*asked_of(dented_room(gray(0.7, 1)), bounces(3, 4))); }, 4);
  expect_explained(wild_task());
}

PROMISE(trace_path, adds_no_light_from_outside) {
  for_all(
      [] {
        expect_estimate(
            *asked_of(wall_under_the_sky(color(0.1, 1), either_way()), bounces_from(2, 2, 5)));
      },
      kCases);
}

PROMISE(trace_path, keeps_what_it_has_found) {
  for_all([] { expect_estimate(*asked_of(sunny_wall(gray(0.2, 1)), bounces_from(1, 2, 5))); }, 20);
}

PROMISE(trace_path, takes_any_amount_of_light) {
  for_all(
      [] {
        expect_estimate(*asked_of(round_room(gray(0.3, 0.8), extreme()), bounces(1, 3)), 2000);
      },
      kCases);
  for_all(
      [] {
        expect_estimate(
            *asked_of(room_around_a_lamp(gray(0.3, 0.8), either_way(), extreme()), bounces(1, 3)),
            2000);
      },
      kCases);
  for_all(
      [] {
        expect_estimate(*asked_of(round_room(gray(0.3, 0.8), brightest()), bounces(1, 3)), 1000);
      },
      2);
}

PROMISE(trace_path, draws_from_the_sampler_alone) {
  // The path of the first call may end or go on.
  const auto expect_independent = [](const rc::Gen<Room>& room) {
    const Case before = *asked_of(sunny_wall(gray(0.2, 1)), bounces(1, 5));
    expect_independent_pairs(*asked_of(room, rc::gen::just(Bounces{2, 3}), real(0.4, 0.7)), before);
  };
  for_all([=] { expect_independent(round_room(gray(0.5, 0.8))); }, 3);
  for_all([=] { expect_independent(glowing_room(gray(0.5, 0.8))); }, 3);
  const auto expect_to_move_on = [](const Case& c) {
    expect_moves_on(c.seed, [&](pt::Sampler& sampler) {
      return pt::trace_path(c.room.scene, c.room.point, c.settings, sampler);
    });
  };
  // Direct light alone moves the sampler on too.
  for (const Direct direct : {Direct::lights, Direct::hemisphere}) {
    for_all(
        [=] {
          expect_to_move_on(*asked_of(wall_under_the_sky(color(0.1, 1), rc::gen::just(direct)),
                                      rc::gen::just(Bounces{1, 1})));
        },
        5);
  }
  // All paths of these scenes leave them.
  for (const auto& open :
       {sunny_wall(gray(0.2, 1)), wall_under_the_sky(color(0.1, 1), either_way())}) {
    for_all([&] { expect_to_move_on(*asked_of(open, bounces_from(2, 2, 5))); }, 10);
  }
  // Calls in turn: the surface or the light has other numbers, or the bounces 0 to 1 become 1 to 0, of which there are none.
  for_all(
      [] {
        const auto [before, now] = *below_a_point_light_in_turn();
        const auto seed = draw("seed", sampler_seed());
        const auto ask = [seed](const Situation& s, Bounces which) {
          return repeat<pt::trace_path>(1, seed, s.scene, s.point, settings_of(which)).front();
        };
        const auto expect_light = [](Rgb found, const Situation& s, Rgb expected) {
          expect_near("the estimate, after one of other numbers", found, expected,
                      4 * kColorPrecision * max_channel(s.expected));
        };
        for (const Situation& s : {before, now, before}) {
          expect_light(ask(s, {0, 1}), s, s.expected);
          expect_light(ask(s, {1, 0}), s, {});
        }
      },
      30);
  expect_explained(wild_task());
}

// At least one path in fifteen finds light.
PROMISE(trace_path, stays_finite) {
  for_all(
      [] {
        const Case c = *grazed_and_black();
        const Rgb albedo = c.room.point.albedo;
        bool lit = is_black(albedo);
        for (const Rgb& one : estimates(c, 500)) {
          expect(pt::is_finite(one) && one.r >= 0 && one.g >= 0 && one.b >= 0,
                 "finite estimates, none below 0", show(one));
          for (int channel = 0; channel < 3; ++channel) {
            if (albedo[channel] > 0) continue;
            expect(one[channel] == 0, "no light of a color that nothing reflects", show(one));
          }
          lit = lit || max_channel(one) > 0;
        }
        expect(lit, "light in some of 500 estimates", "500 black estimates");
      },
      2 * kCases);
  for_all([] {
    const Case c = *grazed_and_black();
    pt::Sampler sampler = sampler_of_a_rare_number(16, 0x1p-53);
    const Rgb one = pt::trace_path(c.room.scene, c.room.point, c.settings, sampler);
    expect(pt::is_finite(one), "a finite estimate whatever the random numbers are", show(one));
  });
}

}  // namespace
}  // namespace grader::check
