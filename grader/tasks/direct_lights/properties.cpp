#include "grader/property/generators.h"
#include "grader/property/property.h"
#include "grader/property/repeat.h"
#include "grader/property/scenes.h"
#include "pt/tasks/direct_lights.h"

#include <cmath>

#include <fmt/format.h>

namespace grader {
namespace {

using pt::Rgb;
using pt::Vec3;

constexpr int kCases = 20;

Rgb any_radiance() { return *color(0.25, 4); }
Vec3 any_position() { return *real(0.5, 4) * *direction_above(); }
int any_samples() { return draw("samples a call", whole(1, 16)); }

std::vector<Rgb> estimates(const Situation& s, int calls, int samples) {
  return repeat<pt::direct_lights>(calls, draw("seed", sampler_seed()), s.scene, s.point, samples);
}

void expect_estimate(const Situation& s, int samples) {
  expect_mean(fmt::format("the mean, {} samples a call", samples),
              mean_of(estimates(s, samples < 4 ? 4000 : 2000, samples)), s.expected,
              1e-9 * max_channel(s.expected));
}

// Where nothing is left to chance, every single estimate has to be right.
void expect_always(const Situation& s, int samples) {
  for (const Rgb& one : estimates(s, 8, samples)) {
    expect_near(fmt::format("each estimate, {} samples a call", samples), one, s.expected,
                1e-9 * max_channel(s.expected));
  }
}

// Lit by whatever `light` puts on the stage.
template <class Light>
rc::Gen<Situation> lit_by(Light light, const rc::Gen<Pose>& poses = unturned_pose(),
                          const rc::Gen<bool>& from_behind = rc::gen::just(false)) {
  return rc::gen::exec([=] {
    Stage stage(*poses);
    light(stage);
    return stage.patch(*color(0.1, 1), *direction_above(), *from_behind).done();
  });
}

void rectangle(Stage& stage) {
  stage.rectangle(*rectangle_above(1.2, 0.1, 1.5), any_radiance(), Body::none);
}

void ball(Stage& stage) {
  const Vec3 towards = *direction_above(1.0);
  const double distance = *real(0.5, 3);
  stage.ball(distance * towards, distance * *real(0.05, 0.5), any_radiance(), Body::none);
}

void point_light(Stage& stage) { stage.point_light(any_position(), any_radiance()); }

void directional_light(Stage& stage) {
  stage.directional_light(*direction_above(), any_radiance());
}

PROMISE(direct_lights, matches_a_rectangle) {
  for_all([] { expect_estimate(*lit_by(rectangle), any_samples()); }, kCases);
}

PROMISE(direct_lights, matches_a_sphere) {
  for_all([] { expect_estimate(*lit_by(ball), any_samples()); }, kCases);
}

PROMISE(direct_lights, matches_a_point_light) {
  for_all([] { expect_always(*lit_by(point_light), 1); });
}

PROMISE(direct_lights, matches_a_directional_light) {
  for_all([] { expect_always(*lit_by(directional_light), 1); });
}

PROMISE(direct_lights, matches_the_sky) {
  for_all(
      [] {
        const Situation s = *rc::gen::exec([] {
          const Vec3 n = pt::frame_from_normal({0, 1, 0}).to_world(*direction_above(1.8));
          Stage stage({pt::frame_from_normal(n), *point(), *magnitude(1e-2, 1e2)});
          return stage.sky(any_radiance()).patch(*color(0.1, 1), *direction_above()).done();
        });
        expect_estimate(s, any_samples());
      },
      kCases);
}

// Without surfaces but the patch, so that no light hides another.
PROMISE(direct_lights, adds_the_lights_up) {
  for_all(
      [] {
        const auto several = [](Stage& stage) {
          for (int k = *whole(0, 4); k > 0; --k) {
            const int kind = *whole(0, 3);
            if (kind == 0) point_light(stage);
            if (kind == 1) directional_light(stage);
            if (kind == 2) {
              stage.rectangle(*rectangle_above(0.8, 0.2, 1), any_radiance(), Body::none);
            }
            if (kind == 3) stage.ball(2 * *direction_above(1.0), 0.5, any_radiance(), Body::none);
          }
        };
        expect_estimate(*lit_by(several), any_samples());
      },
      30);
}

PROMISE(direct_lights, averages_over_the_samples) {
  for_all(
      [] {
        const Situation s = *lit_by([](Stage& stage) {
          stage.rectangle(*rectangle_above(0.8, 0.2, 1), any_radiance(), Body::none);
        });
        expect_estimate(s, 1);
        expect_estimate(s, draw("samples a call", whole(2, 32)));
      },
      12);
}

PROMISE(direct_lights, takes_the_samples_asked_for) {
  for_all(
      [] {
        const Situation s = *lit_by([](Stage& stage) {
          stage.rectangle(*rectangle_above(0.8, 0.5, 1.5), any_radiance(), Body::none, 0.5);
        });
        const Mean one = mean_of(estimates(s, 2000, 1)), many = mean_of(estimates(s, 2000, 16));
        const double ratio = many.standard_error.g / one.standard_error.g;
        expect(ratio < 0.35, "16 samples with a quarter of the noise of one, or less",
               fmt::format("{:.3g} times the noise", ratio));
      },
      8);
}

PROMISE(direct_lights, is_exact_for_delta_lights) {
  for_all([] {
    const Situation s = *lit_by([](Stage& stage) {
      for (int k = *whole(1, 3); k > 0; --k) {
        *rc::gen::arbitrary<bool>() ? point_light(stage) : directional_light(stage);
      }
    });
    expect_always(s, any_samples());
  });
}

PROMISE(direct_lights, casts_shadows) {
  for_all(
      [] {
        const Situation half = *lit_by([](Stage& stage) {
          stage.rectangle(*rectangle_above(0.8, 0.3, 1.5), any_radiance(), Body::none,
                          *real(0.25, 0.75));
        });
        expect_estimate(half, any_samples());
      },
      kCases);
  for_all(
      [] {
        const Situation dark = *lit_by([](Stage& stage) {
          const int kind = *whole(0, 2);
          if (kind == 0) stage.point_light(any_position(), any_radiance(), true);
          if (kind == 1) stage.directional_light(*direction_above(), any_radiance(), true);
          if (kind == 2) {
            stage.rectangle(*rectangle_above(0.8, 0.3, 1.5), any_radiance(), Body::none, 1);
          }
        });
        expect_always(dark, any_samples());
      },
      50);
}

// Each light with a surface of its own, if it can have one, and often with a wall behind it.
PROMISE(direct_lights, is_not_hidden_by_the_light_itself) {
  for_all(
      [] {
        const Situation s = *lit_by([](Stage& stage) {
          const Rectangle shape = *rectangle_above(0.8, 0.2, 1);
          const bool is_mesh = *rc::gen::arbitrary<bool>();
          is_mesh ? stage.mesh(shape, any_radiance(), Body::surface)
                  : stage.rectangle(shape, any_radiance(), Body::surface);
          if (*rc::gen::arbitrary<bool>()) {
            stage.surface(shape.part(-1, 2, -1, 2).scaled(*real(1.01, 2)), *color());
          }
        });
        expect_estimate(s, any_samples());
      },
      kCases);
  for_all(
      [] {
        const Situation s = *lit_by([](Stage& stage) {
          const Vec3 at = any_position();
          const pt::Frame around = pt::frame_from_normal(normalize(at));
          stage.point_light(at, any_radiance());
          stage.surface({*real(1.01, 2) * at, 9 * around.x, 9 * around.y}, *color());
        });
        expect_always(s, 1);
      },
      50);
  for_all(
      [] {
        const Situation s = *lit_by([](Stage& stage) {
          stage.ball(*real(0.5, 3) * *direction_above(1.0), 0.2, any_radiance(), Body::surface);
        });
        expect_estimate(s, any_samples());
      },
      10);
}

void light_below(Stage& stage) {
  const Vec3 above = *real(0.5, 4) * *direction_above(1.0);
  const Vec3 at{above.x, above.y, -above.z};
  const int kind = *whole(0, 2);
  if (kind == 0) stage.point_light(at, any_radiance());
  if (kind == 1) stage.directional_light(normalize(at), any_radiance());
  if (kind == 2) stage.ball(at, 0.2, any_radiance(), Body::none);
}

// Above the patch, but it emits to the other side.
void light_turned_away(Stage& stage) {
  stage.rectangle((*rectangle_above(0.8, 0.2, 1)).flipped(), any_radiance(), Body::none);
}

// An upright rectangle that goes on below the horizon.
void light_across_the_horizon(Stage& stage) {
  const double tall = *real(1, 2);
  stage.rectangle({{-1, 0, tall * *real(-0.2, 0.2)}, {0, 1, 0}, {0, 0, tall}}, any_radiance(),
                  Body::none);
}

PROMISE(direct_lights, keeps_light_on_its_side) {
  const auto either_side = [] { return rc::gen::arbitrary<bool>(); };
  for_all(
      [&] {
        const bool below = *rc::gen::arbitrary<bool>();
        const Situation dark =
            *lit_by(below ? light_below : light_turned_away, unturned_pose(), either_side());
        expect_always(dark, any_samples());
      },
      50);
  for_all(
      [&] {
        const Situation s = *lit_by(light_across_the_horizon, unturned_pose(), either_side());
        expect_estimate(s, any_samples());
      },
      kCases);
}

PROMISE(direct_lights, reflects_the_albedo) {
  for_all([] {
    Situation s = *lit_by(*rc::gen::arbitrary<bool>() ? point_light : directional_light);
    for (int channel = 0; channel < 3; ++channel) {
      s.expected[channel] /= s.point.albedo[channel];
      s.point.albedo[channel] = *rc::gen::element(0.0, 0.001, 0.5, 0.999, 1.0);
      s.expected[channel] *= s.point.albedo[channel];
    }
    expect_always(s, 1);
  });
}

PROMISE(direct_lights, turns_with_the_surface) {
  for_all([] { expect_always(*lit_by(point_light, pose()), 1); });
  for_all([] { expect_estimate(*lit_by(rectangle, pose()), any_samples()); }, kCases);
}

PROMISE(direct_lights, starts_off_the_surface) {
  for_all([] { expect_always(*lit_by(point_light, pose(1e4)), 1); });
  // A dark lid close above the patch.
  for_all([] {
    const auto under_a_lid = [](Stage& stage) {
      const Vec3 towards = *direction_above(1.4);
      stage.point_light(*real(0.5, 4) * towards, any_radiance());
      stage.surface({{0, 0, 1e-3}, {0.25, 0, 0}, {0, 0.25, 0}}, pt::gray(0.5));
    };
    Situation dark = *lit_by(under_a_lid, pose(1e4));
    dark.expected = {};
    expect_always(dark, 1);
  });
}

}  // namespace
}  // namespace grader
