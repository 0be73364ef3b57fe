#include "grader/property/closed_forms.h"
#include "grader/property/generators.h"
#include "grader/property/property.h"
#include "grader/property/repeat.h"
#include "grader/property/scenes.h"
#include "pt/tasks/direct_hemisphere.h"

#include <cmath>

#include <fmt/format.h>

namespace grader {
namespace {

using pt::Rgb;
using pt::Vec3;

constexpr int kCases = 12;

// Calls of few samples are many, so that each case looks in about as many directions.
std::vector<Rgb> estimates(const Situation& s, int samples) {
  const int calls = samples < 4 ? 4000 : 2000;
  return repeat<pt::direct_hemisphere>(calls, draw("seed", sampler_seed()), s.scene, s.point,
                                       samples);
}

void expect_estimate(const Situation& s) {
  const int samples = draw("samples a call", whole(1, 16));
  expect_mean(fmt::format("the mean, {} samples a call", samples), mean_of(estimates(s, samples)),
              s.expected, 1e-9 * max_channel(s.expected));
}

// Every single estimate is exactly this.
void expect_always(const Situation& s, Rgb expected) {
  for (const Rgb& one : estimates(s, 1)) expect_near("each estimate", one, expected, 0);
}

Rgb any_radiance() { return *color(0.25, 4); }

// The walls of a room without its floor, in pieces: every direction above the patch meets one.
std::vector<Rectangle> dome(int pieces) {
  std::vector<Rectangle> cells;
  for (const Rectangle& wall : cube()) {
    if (wall.center.z == 0) continue;
    for (int i = 0; i < pieces * pieces; ++i) {
      const int column = i % pieces, row = i / pieces;
      const double a = column, b = row, width = 1.0 / pieces;
      cells.push_back(wall.part(a * width, (a + 1) * width, b * width, (b + 1) * width));
    }
  }
  return cells;
}

// A patch in a room whose walls all glow: it shows its albedo times their radiance.
rc::Gen<Situation> in_a_glowing_room(double range) {
  return rc::gen::exec([range] {
    Stage stage(*pose(range));
    const Rgb radiance = any_radiance(), albedo = *color(0.1, 1);
    for (const Rectangle& wall : dome(1)) stage.surface(wall, pt::gray(0.5), radiance);
    Situation s = stage.patch(albedo, *direction_above(), *rc::gen::arbitrary<bool>()).done();
    s.expected = albedo * radiance;
    return s;
  });
}

// A patch under a rectangle that fills much of what it sees.
rc::Gen<Situation> under_a_rectangle(const rc::Gen<Pose>& poses, const rc::Gen<double>& hidden) {
  return rc::gen::exec([=] {
    Stage stage(*poses);
    stage.rectangle(*rectangle_above(0.9, 1.6, 2.5), any_radiance(), Body::surface, *hidden);
    return stage.patch(*color(0.1, 1), *direction_above()).done();
  });
}

PROMISE(direct_hemisphere, sees_the_sky) {
  for_all(
      [] {
        const Situation s = *rc::gen::exec([] {
          const Vec3 n = pt::frame_from_normal({0, 1, 0}).to_world(*direction_above(1.8));
          const Pose tilted{pt::frame_from_normal(n), *point(), *magnitude(1e-2, 1e2)};
          Stage stage(tilted);
          return stage.sky(any_radiance()).patch(*color(0.1, 1), *direction_above()).done();
        });
        expect_estimate(s);
      },
      kCases);
}

PROMISE(direct_hemisphere, sees_a_light_of_known_size) {
  for_all([] { expect_estimate(*under_a_rectangle(unturned_pose(), rc::gen::just(0.0))); }, kCases);
}

PROMISE(direct_hemisphere, takes_the_emission_of_what_is_hit) {
  for_all(
      [] {
        const Situation s = *rc::gen::exec([] {
          Stage stage(*unturned_pose());
          const Rectangle shape = *rectangle_above(0.5, 1.6, 2.5);
          const Rgb radiance = any_radiance();
          // Not in the list of lights: only rays find it.
          stage.surface(shape, *color(), radiance);
          Situation made = stage.patch(*color(0.1, 1), *direction_above()).done();
          made.expected = made.point.albedo * radiance / pt::kPi *
                          cosine_of_polygon(shape.corners(), {}, {0, 0, 1});
          return made;
        });
        expect_estimate(s);
      },
      kCases);
}

PROMISE(direct_hemisphere, adds_no_emission_of_its_own) {
  for_all(
      [] {
        const Situation dark = *rc::gen::exec([] {
          Stage stage(*pose());
          stage.surface(*rectangle_above(1, 0.5, 2), *color());
          return stage.patch(*color(0.1, 1), *direction_above(), false, any_radiance()).done();
        });
        expect_always(dark, {});
      },
      5);
}

PROMISE(direct_hemisphere, sees_what_is_in_the_way) {
  for_all([] { expect_estimate(*under_a_rectangle(unturned_pose(), real(0.3, 0.6))); }, kCases);
  for_all([] { expect_always(*under_a_rectangle(unturned_pose(), rc::gen::just(1.0)), {}); }, 5);
}

PROMISE(direct_hemisphere, sees_only_the_bright_side) {
  for_all(
      [] {
        const Situation turned_away = *rc::gen::exec([] {
          Stage stage(*unturned_pose());
          const Rectangle shape = (*rectangle_above(0.9, 1.6, 2.5)).flipped();
          stage.rectangle(shape, any_radiance(), Body::surface);
          return stage.patch(*color(0.1, 1), *direction_above()).done();
        });
        expect_always(turned_away, {});
      },
      5);
}

PROMISE(direct_hemisphere, turns_with_the_surface) {
  for_all([] { expect_estimate(*under_a_rectangle(pose(), rc::gen::just(0.0))); }, kCases);
}

PROMISE(direct_hemisphere, looks_from_the_side_it_is_seen_on) {
  for_all(
      [] {
        const Situation s = *rc::gen::exec([] {
          Stage stage(*unturned_pose());
          stage.rectangle(*rectangle_above(0.9, 1.6, 2.5), any_radiance(), Body::surface);
          return stage.patch(*color(0.1, 1), *direction_above(), true).done();
        });
        expect_estimate(s);
      },
      kCases);
}

PROMISE(direct_hemisphere, reflects_the_albedo) {
  for_all(
      [] {
        Situation s = *under_a_rectangle(unturned_pose(), rc::gen::just(0.0));
        for (int channel = 0; channel < 3; ++channel) {
          s.expected[channel] /= s.point.albedo[channel];
          s.point.albedo[channel] = *rc::gen::element(0.0, 0.001, 0.5, 0.999, 1.0);
          s.expected[channel] *= s.point.albedo[channel];
        }
        expect_estimate(s);
      },
      kCases);
}

// In a room that glows all over, one direction gives 2 albedo L cos, and cos is uniform: a variance
// of 1/3 relative to the mean. n of them leave 1/n of it; cleverly placed ones even less.
PROMISE(direct_hemisphere, takes_the_samples_asked_for) {
  for_all(
      [] {
        const Situation s = *in_a_glowing_room(1);
        const int samples = draw("samples a call", rc::gen::element(1, 2, 3, 8, 16));
        const std::vector<Rgb> draws = repeat<pt::direct_hemisphere>(
            3000, draw("seed", sampler_seed()), s.scene, s.point, samples);
        const Mean mean = mean_of(draws);
        expect_mean("the mean", mean, s.expected);
        const double n = static_cast<double>(draws.size());
        const double relative = mean.standard_error.r / s.expected.r;
        const double variance = n * relative * relative * samples;
        expect(variance < 1.2 / 3,
               fmt::format("a relative variance of 1/3 or less a sample, from {} samples", samples),
               show(variance));
      },
      kCases);
}

PROMISE(direct_hemisphere, starts_off_the_surface) {
  for_all(
      [] {
        const Situation s = *in_a_glowing_room(1e4);
        for (const Rgb& one : repeat<pt::direct_hemisphere>(200, draw("seed", sampler_seed()),
                                                            s.scene, s.point, 1)) {
          expect(max_channel(one) > 0, "light from every direction",
                 "none: a ray met the surface that it started on");
        }
      },
      30);
  // A dark lid close above the patch: only directions within a hundredth of the surface pass it.
  for_all(
      [] {
        const Situation s = *rc::gen::exec([] {
          Stage stage(*pose(1e4));
          for (const Rectangle& wall : dome(1)) stage.surface(wall, pt::gray(0.5), pt::gray(1));
          stage.surface({{0, 0, 1e-3}, {0.25, 0, 0}, {0, 0.25, 0}}, pt::gray(0.5));
          return stage.patch(pt::gray(0.5), *direction_above()).done();
        });
        for (const Rgb& one :
             repeat<pt::direct_hemisphere>(50, draw("seed", sampler_seed()), s.scene, s.point, 1)) {
          expect(max_channel(one) < 0.01, "no light through a lid close to the surface", show(one));
        }
      },
      30);
}

// Each piece of the room has a hue of its own, which tells where one direction went.
PROMISE(direct_hemisphere, spreads_evenly_over_the_hemisphere) {
  for_all(
      [] {
        const std::vector<Rectangle> cells = dome(3);
        const Situation s = *rc::gen::exec([cells] {
          Stage stage(*pose());
          for (std::size_t i = 0; i < cells.size(); ++i) {
            stage.surface(cells[i], pt::gray(0.5), {1, static_cast<double>(i + 1), 0});
          }
          return stage.patch(pt::gray(0.5), *direction_above()).done();
        });
        const std::vector<Rgb> draws =
            repeat<pt::direct_hemisphere>(5000, draw("seed", sampler_seed()), s.scene, s.point, 1);
        std::vector<int> found(cells.size());
        for (const Rgb& draw : draws) {
          const double cell = std::round(draw.g / draw.r) - 1;
          if (cell >= 0 && cell < static_cast<double>(cells.size())) {
            ++found[static_cast<std::size_t>(cell)];
          }
        }
        double chi_square = 0;
        for (std::size_t i = 0; i < cells.size(); ++i) {
          const std::vector<Vec3> c = cells[i].corners();
          const double share =
              (solid_angle(c[0], c[1], c[2], {}) + solid_angle(c[0], c[2], c[3], {})) /
              (2 * pt::kPi);
          const double expected = share * static_cast<double>(draws.size());
          chi_square += (found[i] - expected) * (found[i] - expected) / expected;
        }
        const double limit = chi_square_limit(static_cast<int>(cells.size()));
        expect(chi_square < limit,
               fmt::format("directions in proportion to the solid angle: chi-square of {} in {} "
                           "pieces of a room below {:.4g}",
                           draws.size(), cells.size(), limit),
               fmt::format("{:.4g}", chi_square));
      },
      4);
}

}  // namespace
}  // namespace grader
