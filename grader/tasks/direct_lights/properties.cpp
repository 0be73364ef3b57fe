#include "grader/check/language/in_a_row.h"
#include "grader/check/scenes/in_turn.h"
#include "grader/tasks/direct_lights/estimates.h"
#include "grader/tasks/direct_lights/inputs.h"
#include "grader/tasks/direct_lights/shadows.h"
#include "grader/tasks/direct_lights/wild.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

namespace grader::check {
namespace {

using namespace direct_lights_inputs;
using pt::Rgb;

constexpr int kCases = 20;

int any_samples() { return draw("samples per call", rc::gen::element(1, 2, 3, 5, 16, 17)); }

// The ends of the sizes that a scene may have.
constexpr std::array kSizes{1e-6, 1e6};

PROMISE(direct_lights, matches_a_rectangle) {
  for_all([] { expect_estimate(*lit_by(rectangle), any_samples()); }, kCases);
  for (const double size : kSizes) {
    for_all([=] { expect_estimate(*lit_without_surfaces(rectangle, size), 1); }, 1);
  }
  for_all([] { expect_estimate(*lit_by(small_rectangle), any_samples()); }, 5);
  for_all([] { expect_estimate(*lit_by(parallelogram), any_samples()); }, 5);
  for (const bool narrow_u : {true, false}) {
    for_all([=] { expect_independent_sides(narrow_u); }, 1);
  }
  expect_explained(wild_task());
}

PROMISE(direct_lights, matches_a_sphere) {
  for_all([] { expect_estimate(*lit_by(ball), any_samples()); }, kCases);
  for (const double size : kSizes) {
    for_all([=] { expect_estimate(*lit_without_surfaces(ball, size), 1); }, 1);
  }
  for_all([] { expect_estimate(*lit_by(grazing_ball), any_samples()); }, 5);
  expect_explained(wild_task());
}

PROMISE(direct_lights, matches_a_point_light) {
  for_all([] { expect_always(*lit_by(point_light), 1); });
  for_all([] { expect_always(*lit_by(grazing_point_light), 1); }, 50);
  for (const double size : kSizes) {
    for_all([=] { expect_always(*lit_without_surfaces(point_light, size), 1); }, 5);
  }
  expect_explained(wild_task());
}

PROMISE(direct_lights, matches_a_directional_light) {
  for_all([] { expect_always(*lit_by(directional_light), 1); });
  for_all([] { expect_always(*lit_by(grazing_directional_light), 1); }, 50);
  expect_explained(wild_task());
}

PROMISE(direct_lights, matches_the_sky) {
  for_all([] { expect_estimate(*under_the_sky(2.7), any_samples()); }, kCases);
  for_all([] { expect_estimate(*under_the_sky(1, -1), any_samples()); }, 10);
  for_all([] { expect_estimate(*sky_below_the_walls(), any_samples()); }, 2);
  for_all([] { expect_estimate(*sky_below_the_walls(), draw("samples per call", whole(65, 300))); },
          2);
  expect_explained(wild_task());
}

// The patch is the only surface, so that no light hides another.
PROMISE(direct_lights, adds_the_lights_up) {
  const auto expect_lights = [](int lights, int samples) {
    const Situation s = *lit_by([lights](SceneMaker& maker) {
      for (int k = 0; k < lights; ++k) any_light(maker);
    });
    expect_estimate(s, samples);
  };
  for_all(
      [&] {
        const int lights = draw("lights", rc::gen::element(0, 1, 2, 3, 5, 17, 40));
        expect_lights(lights, any_samples());
      },
      30);
  for_all([&] { expect_lights(100, 1); }, 1);
  for_all([] { expect_estimate(*lit_by(twins), any_samples()); }, 12);
  for (const bool hidden_first : {true, false}) {
    for_all([=] { expect_independent_lights(hidden_first); }, 1);
  }
  for_all([&] {
    const int lights = draw("lights", rc::gen::element(0, 1, 2, 3, 5, 17, 40, 100, 300));
    const Situation s = *lit_by([lights](SceneMaker& maker) {
      for (int k = 0; k < lights; ++k) any_delta_light(maker);
    });
    expect_always(s, any_samples());
  });
  // Numbers that are hardly ever drawn: the ends of [0, 1), and one that a float rounds to 1.
  for_all([] {
    const int lights = draw("lights", rc::gen::element(2, 3, 5, 17));
    const Situation s = *lit_by([lights](SceneMaker& maker) {
      for (int k = 0; k < lights; ++k) any_delta_light(maker);
    });
    pt::Sampler sampler = sampler_of_a_rare_number(4);
    expect_near("the estimate, whatever the random numbers are",
                pt::direct_lights(s.scene, s.point, 1, sampler), s.expected, tolerance(s));
  });
  // A light that gives nothing must not end the sum, nor change the part of the lights after it.
  for_all([] { expect_always(*lit_by(some_hidden_or_below), any_samples()); }, 30);
  // Lights that share random numbers would be bright and dark together.
  const auto expect_no_correlation = [](const Situation& s, int draws, int samples) {
    if (needs_no_mean(s, samples)) return;
    const std::vector<Rgb> found = estimates(s, draws, samples);
    for (const auto& [a, b] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{2, 0}}) {
      const double r = correlation(found, a, b);
      expect(std::abs(r) < (kStandardErrors + 1) / std::sqrt(draws),
             "red, green and blue lights that do not depend on each other",
             fmt::format("a correlation of {:.2f} between lights of two colors", r));
    }
  };
  for (int kind = 0; kind <= kAreaKinds; ++kind) {
    for (const auto& few_or_many : {whole(3, 8), whole(9, 15)}) {
      for_all(
          [&] {
            const int lights = draw("lights", few_or_many);
            const Situation s = *lit_by(
                [kind, lights](SceneMaker& maker) { lights_of_three_colors(maker, kind, lights); });
            expect_no_correlation(s, 2000, lights < 9 ? draw("samples per call", whole(1, 2)) : 1);
          },
          1);
    }
  }
  for_all([&] { expect_no_correlation(*lit_by(red_mesh_and_green_lamp), 4000, 1); }, 1);
  expect_explained(wild_task());
}

PROMISE(direct_lights, takes_lights_of_any_brightness) {
  for (int kind = 0; kind < 5; ++kind) {
    for (const auto& bright : {rc::gen::just(1e-4), rc::gen::just(1e6), brightness()}) {
      for_all(
          [&] {
            const Situation s = *lit_by([&](SceneMaker& maker) {
              light_of_radiance(maker, kind, *bright * any_radiance());
            });
            expect_estimate(s, any_samples());
          },
          1);
      if (testing::Test::HasFailure()) return;
    }
  }
  for_all(
      [] {
        const auto bright = [](SceneMaker& maker) {
          close_point_light(maker, 1e6 * any_radiance());
        };
        expect_always(*lit_by(bright), 1);
      },
      10);
}

PROMISE(direct_lights, averages_over_the_samples) {
  const auto under_a_lamp = [] { return lit_by(lamp); };
  for_all(
      [&] {
        const Situation s = *under_a_lamp();
        expect_estimate(s, 1);
        expect_estimate(s, draw("samples per call", whole(2, 33)));
      },
      12);
  for (const int many : {100, 1000}) {
    for_all([&] { expect_estimate(*under_a_lamp(), many); }, 1);
  }
  for_all([] { expect_estimate(*under_the_sky(1.8), 100); }, 3);
  for (const auto& light : {half_hidden_mesh, ball}) {
    for_all([&] { expect_estimate(*lit_by(light), 100); }, 1);
  }
}

PROMISE(direct_lights, takes_the_samples_asked_for) {
  for_all(
      [] {
        constexpr std::array kSamples{1, 2, 3, 7, 16, 100, 1000};
        const Situation s = *lit_by(half_hidden_lamp);
        if (std::ranges::all_of(kSamples, [&](int n) { return needs_no_mean(s, n); })) return;
        const std::vector<Rgb> of_one = estimates(s, 4000, 1);
        expect_mean("the mean, 1 sample per call", mean_of(of_one), s.expected,
                    noise_of_lights(s, 1), tolerance(s));
        for (const int samples : std::span(kSamples).subspan(1)) {
          expect_less_noise(s, of_one, samples, std::clamp(32000 / samples, 100, 2000));
        }
      },
      3);
  // The same for lights of the other kinds.
  const rc::Gen<Situation> others[] = {lit_by(half_hidden_mesh), half_hidden_ball(),
                                       under_the_sky(1)};
  for (const auto& light : others) {
    for_all(
        [&] {
          const Situation s = *light;
          const int samples = draw("samples per call", whole(65, 300));
          if (needs_no_mean(s, 1) && needs_no_mean(s, samples)) return;
          expect_less_noise(s, estimates(s, 4000, 1), samples, 200);
        },
        1);
  }
  // A counter of two bytes leaves one of these samples. By chance, the mean of so many is off by seven of
  // its deviations less than once in a hundred billion times.
  for_all(
      [] {
        constexpr int kMost = 65537;
        const Situation s = *lit_by(lamp);
        const double off = 7 * max_channel(noise_of_lights(s, kMost).deviation) + tolerance(s);
        for (const Rgb& one : estimates(s, 3, kMost)) {
          expect_near(fmt::format("each estimate of {} samples", kMost), one, s.expected, 2 * off);
        }
      },
      1);
  // The samples are for each light, however many lights there are.
  for_all(
      [] {
        const Situation s = *lit_by([](SceneMaker& maker) {
          for (int k = 0; k < 40; ++k) lamp(maker);
        });
        if (needs_no_mean(s, 1) && needs_no_mean(s, 200)) return;
        expect_less_noise(s, estimates(s, 1000, 1), 200, 30);
      },
      1);
  expect_explained(wild_task());
}

PROMISE(direct_lights, is_exact_for_delta_lights) {
  for_all([] {
    const Situation s = *lit_by([](SceneMaker& maker) {
      for (int k = *whole(1, 3); k > 0; --k) any_delta_light(maker);
    });
    expect_always(s, draw("samples per call", rc::gen::element(1, 2, 3, 16, 17, 100, 1000)));
  });
}

PROMISE(direct_lights, casts_shadows) {
  for_all([] { expect_estimate(*glowing_or_not(half_hidden_lamp), any_samples()); }, kCases);
  for_all([] { expect_estimate(*lit_by(half_hidden_mesh), any_samples()); }, 3);
  for_all([] { expect_estimate(*lit_by(half_hidden_mesh_of_many_faces), any_samples()); }, 1);
  for_all([] { expect_estimate(*half_hidden_ball(), any_samples()); }, 3);
  for_all([] { expect_always(dark(*glowing_or_not(hidden_light)), any_samples()); }, 50);
  for_all([] { expect_always(*lit_by(beside_a_wall), 1); }, 50);
  for (int kind = 0; kind < kKinds; ++kind) {
    for (const double size : {1.0, 1e6}) {
      for_all([=] { expect_always(*hidden_by_a_ball(kind, size), 16); }, 1);
    }
  }
}

// Each light has a surface, if its kind can have one, and often a wall behind it.
PROMISE(direct_lights, is_not_hidden_by_the_light_itself) {
  for_all([] { expect_estimate(*lit_by(lamp_with_a_body), any_samples()); }, kCases);
  for_all([] { expect_always(*lit_by(point_light_before_a_wall), 1); }, 50);
  for_all([] { expect_estimate(*lit_by(ball_with_a_body), any_samples()); }, 10);
}

PROMISE(direct_lights, keeps_light_on_its_side) {
  const auto either_side = [] { return rc::gen::arbitrary<bool>(); };
  for_all(
      [&] {
        const bool below = *rc::gen::arbitrary<bool>();
        const Situation s =
            *lit_by(below ? light_below : light_turned_away, unturned_pose(), either_side());
        expect_always(s, any_samples());
      },
      50);
  for_all(
      [&] { expect_always(*lit_by(light_edge_on, unturned_pose(), either_side()), any_samples()); },
      10);
  for_all(
      [&] {
        const Situation s = *lit_by(light_across_the_horizon, unturned_pose(), either_side());
        expect_estimate(s, any_samples());
      },
      kCases);
  // Light from above, of each kind, on the back of the surface.
  for (int kind = 0; kind < kKinds; ++kind) {
    const auto light = [kind](SceneMaker& maker) { light_of_kind(maker, kind); };
    for_all([&] { expect_estimate(*lit_by(light, unturned_pose(), rc::gen::just(true)), 2); }, 2);
  }
}

PROMISE(direct_lights, reflects_the_albedo) {
  for_all([] {
    const bool glows = *rc::gen::arbitrary<bool>();
    Situation s = *white_patch(glows);
    for (int channel = 0; channel < 3; ++channel) {
      s.point.albedo[channel] = draw(fmt::format("but its albedo in {}", kChannels[channel]),
                                     rc::gen::element(0.0, 0.001, 0.5, 0.999, 1.0));
      s.expected[channel] *= s.point.albedo[channel];
    }
    expect_always(s, 1);
  });
  // A surface that is dark in all channels is not black.
  for_all(
      [] {
        Situation s = *white_patch(false);
        const double part = draw("but its albedo times", magnitude(1e-8, 1e-3));
        s.point.albedo *= part;
        s.expected *= part;
        s.facing *= part;
        expect_always(s, 1);
      },
      10);
  for_all([] { expect_always(*white_patch(false), 1); }, 2);
}

PROMISE(direct_lights, works_in_every_orientation) {
  for_all([] { expect_always(*lit_by(point_light, pose()), 1); });
  for_all([] { expect_estimate(*lit_by(rectangle, pose()), any_samples()); }, kCases);
  for_all([] { expect_always(*lit_and_smoothly_shaded(), 1); }, 20);
  for (int kind = 0; kind < kAreaKinds; ++kind) {
    for_all([kind] { expect_estimate(*smoothly_shaded_under(kind), any_samples()); }, 1);
  }
}

PROMISE(direct_lights, starts_off_the_surface) {
  // Small and large scenes, close to the world's origin and far from it.
  const auto anywhere = [] { return rc::gen::oneOf(pose(1e6), pose(1e6, 1e4)); };
  for_all([&] { expect_always(*lit_by(point_light, anywhere()), 1); }, 200);
  for_all([] { expect_always(*lit_and_strongly_interpolated(any_delta_light, 1e6), 1); }, 50);
  for (int kind = 0; kind < kAreaKinds; ++kind) {
    const auto light = [kind](SceneMaker& maker) { area_light(maker, kind, any_radiance(), 1.2); };
    for_all([&] { expect_estimate(*lit_by(light, anywhere()), 1); }, 2);
    for_all([&] { expect_estimate(*lit_and_strongly_interpolated(light, 1e6), 1); }, 6);
  }
  // A dark lid close above the patch.
  for_all([&] { expect_always(dark(*lit_by(under_a_lid, anywhere())), 1); });
}

PROMISE(direct_lights, draws_from_the_sampler_alone) {
  for (const auto& few_or_many : {rc::gen::just(1), whole(2, 33), whole(65, 130)}) {
    for_all(
        [&] {
          const Situation s = *lit_by(half_hidden_lamp);
          const int samples = draw("samples per call", few_or_many);
          const auto answers =
              expect_goes_on(draw("seed", sampler_seed()), [&](pt::Sampler& sampler) {
                return pt::direct_lights(s.scene, s.point, samples, sampler);
              });
          expect_mean("the mean of calls in a row", mean_of(answers), s.expected,
                      noise_of_lights(s, samples), tolerance(s));
        },
        1);
  }
  for_all(
      [] {
        const auto [before, now] = *below_a_point_light_in_turn();
        const auto seed = draw("seed", sampler_seed());
        for (const Situation& s : {before, now, before}) {
          const Rgb one = repeat<pt::direct_lights>(1, seed, s.scene, s.point, 1).front();
          expect_near("the estimate, after one of other numbers", one, s.expected, tolerance(s));
        }
      },
      50);
  expect_explained(wild_task());
}

}  // namespace
}  // namespace grader::check
