#include "grader/check/generators/generators.h"
#include "grader/check/language/curve.h"
#include "grader/check/language/property.h"
#include "grader/check/language/repeat.h"
#include "grader/check/scenes/scenes.h"
#include "grader/tasks/direct_lights/coarse_mesh.h"
#include "grader/tasks/direct_lights/inputs.h"
#include "grader/tasks/direct_lights/shadows.h"
#include "pt/tasks/direct_lights.h"

#include <algorithm>
#include <cmath>

namespace grader::check {
namespace {

using namespace direct_lights_inputs;

// The standard deviation of one estimate over its mean.
double relative_deviation(const Situation& s, int draws) {
  const Mean mean = mean_of(repeat<pt::direct_lights>(draws, *sampler_seed(), s.scene, s.point, 1));
  return mean.standard_error.r * std::sqrt(draws) / mean.value.r;
}

pt::Rgb one_estimate(const Situation& s) {
  pt::Sampler sampler(*sampler_seed());
  return pt::direct_lights(s.scene, s.point, 1, sampler);
}

// A patch that nothing hides from a point light, as in the promise. Estimates have no noise.
double wrong_under_a_lamp(const Pose& pose) {
  const Situation s = *lit_by(point_light, rc::gen::just(pose));
  return std::abs(one_estimate(s).r / s.expected.r - 1) < 1e-3 ? 0 : 1;
}

std::vector<Method> offsets() {
  return {{"wrong/no_offset", "no offset"},
          {"wrong/fixed_offset_of_1e-4", "an offset of 1e-4"},
          {"wrong/fixed_offset_of_1e-11", "an offset of 1e-11"},
          {"methods/fixed_lengths", "fixed lengths of 1e-5 and 1e-4"},
          {"methods/fixed_lengths", "fixed lengths, single precision", true}};
}

// The relative deviation of one estimate that chooses a uniform point of a square of side 1, seen from
// `distance` below its middle. A draw is proportional to distance^2 / r^4, and its square is
// integrated. Close to the light the result is 0.33 / distance.
double deviation_below_a_square(double distance) {
  constexpr int kSteps = 400;
  // Steps of equal length in asinh(x / distance): fine where r is small.
  const double end = std::asinh(0.5 / distance), step = end / kSteps;
  double area = 0, sum = 0, squares = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double u = (i + 0.5) * step, x = distance * std::sinh(u);
    for (int j = 0; j < kSteps; ++j) {
      const double v = (j + 0.5) * step, y = distance * std::sinh(v);
      const double weight = std::cosh(u) * std::cosh(v);
      const double r2 = distance * distance + x * x + y * y;
      const double value = distance * distance / (r2 * r2);
      area += weight;
      sum += weight * value;
      squares += weight * value * value;
    }
  }
  return std::sqrt(squares * area / (sum * sum) - 1);
}

CURVE(direct_lights, close_to_a_light) {
  return {.title = "A point close to a square light",
          .input = "distance over the light's side",
          .error = "standard deviation of one estimate over its mean",
          .source = "the density of a point of an area has the squared distance in it",
          .places = by_factors(10, 1e-3, 13),
          // The contract allows twice the deviation of sample_light, or the mean if it is larger.
          .promised = {{10, 1e-3,
                        [](double distance) {
                          return std::max(1.0, 2 * deviation_below_a_square(distance));
                        }}},
          .methods = {{"right/multiple_importance", "multiple importance sampling"},
                      {"right/solid_angle", "sampling the solid angle"}},
          .statistic = Statistic::median,
          .cases = 3,
          .theory = deviation_below_a_square,
          .measure = [](double distance) {
            SceneMaker maker(*unturned_pose());
            maker.rectangle({{0, 0, distance}, {1, 0, 0}, {0, -1, 0}}, pt::gray(1), Body::none);
            return relative_deviation(maker.patch(pt::gray(0.5), {0, 0, 1}).done(), 4000);
          }};
}

CURVE(direct_lights, scale) {
  return {.title = "A surface under a point light, in scenes of any size",
          .input = "size of the scene",
          .error = "share of points that are not right to a thousandth",
          .source = "Waechter and Binder 2019, Ray Tracing Gems, chapter 6",
          .places = by_factors(1e-8, 1e8, 17),
          .promised = {{1e-6, 1e6}},
          .methods = offsets(),
          .statistic = Statistic::mean,
          .measure = [](double size) {
            return wrong_under_a_lamp({*rotation(), size * *point(), size});
          }};
}

CURVE(direct_lights, far_from_the_origin) {
  return {.title = "A surface under a point light, far from the world's origin",
          .input = "distance from the world's origin, in sizes of the scene",
          .error = "share of points that are not right to a thousandth",
          .source = "Waechter and Binder 2019, Ray Tracing Gems, chapter 6",
          .places = by_factors(1, 1e12, 13),
          .promised = {{1, 1e4}},
          .methods = offsets(),
          .statistic = Statistic::mean,
          .measure = [](double away) {
            return wrong_under_a_lamp({*rotation(), *point(away), 1});
          }};
}

CURVE(direct_lights, light_is_a_surface) {
  return {.title = "A light that is a surface of the scene, in scenes of any size",
          .input = "size of the scene",
          .error = "share of points from which it is hidden by itself",
          .source = "a shadow ray that ends on the light may meet it",
          .places = by_factors(1e-8, 1e8, 17),
          .promised = {{1e-6, 1e6}},
          .methods = {{"wrong/shadow_ray_ends_on_the_light", "the ray ends on the light"},
                      {"wrong/shadow_ray_shortened_by_a_fixed_bit", "shortened by a fixed bit"},
                      {"right/shadow_ray_of_its_own", "shortened by a part"},
                      {"methods/fixed_lengths", "fixed lengths of 1e-5 and 1e-4"},
                      {"methods/fixed_lengths", "fixed lengths, single precision", true}},
          .statistic = Statistic::mean,
          .measure = [](double size) {
            const Pose pose{*rotation(), size * *point(), size};
            const Situation s = *lit_by(lamp_with_a_body, rc::gen::just(pose));
            return one_estimate(s).r > 0 ? 0 : 1;
          }};
}

// A dark square, or none, is just before a lamp with a surface of its own. A point below is wrong if it
// is lit behind the square, or dark without it.
CURVE(direct_lights, gap_before_a_light) {
  return {.title = "A surface just before a light",
          .input = "gap between them, as a part of the way to the light",
          .error = "share of points that are lit wrongly, or dark wrongly",
          .source = "the end of a ray can be told from the light only down to rounding",
          .places = by_factors(0.1, 1e-11, 21),
          .promised = {{0.1, 1e-3}},
          .methods = {{"wrong/shadow_ray_ends_on_the_light", "the ray ends on the light"},
                      {"wrong/shadow_ray_of_99_percent", "shortened by a hundredth"},
                      {"right/shadow_ray_of_its_own", "shortened by a part"},
                      {"methods/fixed_lengths", "fixed lengths, single precision", true}},
          .statistic = Statistic::mean,
          .measure = [](double gap) {
            const bool is_hidden = *rc::gen::arbitrary<bool>();
            const Situation s =
                *lit_by([&](SceneMaker& maker) { lamp_behind_a_gap(maker, gap, is_hidden); });
            return (one_estimate(s).r > 0) == is_hidden ? 1 : 0;
          }};
}

// The same for a lid close above the point.
CURVE(direct_lights, gap_above_the_point) {
  return {.title = "Two surfaces close together",
          .input = "gap between them, in sizes of the scene",
          .error = "share of points that are lit wrongly, or dark wrongly",
          .source = "Waechter and Binder 2019, Ray Tracing Gems, chapter 6",
          .places = by_factors(0.1, 1e-13, 25),
          .promised = {{0.1, 1e-3}},
          .methods = offsets(),
          .statistic = Statistic::mean,
          .measure = [](double gap) {
            const bool is_hidden = *rc::gen::arbitrary<bool>();
            const Pose pose{*rotation(), *point(), 1};
            const Situation s =
                *lit_by([&](SceneMaker& maker) { point_light_above_a_gap(maker, gap, is_hidden); },
                        rc::gen::just(pose));
            return (one_estimate(s).r > 0) == is_hidden ? 1 : 0;
          }};
}

// A side of the tube whose middle is a little beyond the edge of the light faces away as a whole. Its
// points up to that edge are black: on average a quarter of a half side, at both edges.
CURVE(direct_lights, coarse_mesh) {
  return {.title = "Smooth normals of a coarse mesh",
          .input = "sides of a tube",
          .error = "share of points that are black though their normal faces the light",
          .source = "Hanika 2021, Ray Tracing Gems II, chapter 4: the shadow terminator",
          .places = {128, 64, 32, 16, 12, 8, 6, 4},
          .promised = {},
          .methods = {},
          .statistic = Statistic::mean,
          .cases = 1000,
          .theory = [](double sides) { return 1 / (2 * sides); },
          .measure =
              [](double sides) {
                return one_estimate(lit_tube(static_cast<int>(sides))).r > 0 ? 0 : 1;
              }};
}

CURVE(direct_lights, sphere_light) {
  return {.title = "A sphere as a lamp",
          .input = "distance from its centre, in radii",
          .error = "relative error of the mean",
          .source = "Pharr, Jakob and Humphreys 2016, Physically Based Rendering, chapter 14.2.2",
          .places = by_factors(1.001, 1e9, 19),
          .promised = {},
          .methods = {{"methods/sphere_cone", "1 - cos as a difference"},
                      {"methods/sphere_cone", "1 - cos as a difference, single precision", true}},
          .statistic = Statistic::bias,
          .measure = [](double distance) {
            SceneMaker maker(*unturned_pose());
            maker.ball({0, 0, 1}, 1 / distance, pt::gray(1), Body::none);
            const Situation s = maker.patch(pt::gray(0.5), {0, 0, 1}).done();
            const Mean mean =
                mean_of(repeat<pt::direct_lights>(50, *sampler_seed(), s.scene, s.point, 1));
            return mean.value.r / s.expected.r - 1;
          }};
}

CURVE(direct_lights, many_lights) {
  return {.title = "Many lights",
          .input = "point lights and directional lights",
          .error = "relative error of the sum",
          .source = "a limit for the number of lights, and errors of a long sum",
          .places = {1, 2, 4, 5, 8, 16, 17, 40, 100, 300, 1000},
          .promised = {{1, 1000, at_most(kColorPrecision)}},
          .methods = {{"wrong/sixteen_lights_at_most", "at most sixteen lights"},
                      {"right/in_float", "single precision"}},
          .cases = 5,
          .measure = [](double lights) {
            SceneMaker maker(*unturned_pose());
            for (int i = 0; i < static_cast<int>(lights); ++i) {
              any_delta_light(maker);
            }
            const Situation s = maker.patch(pt::gray(0.5), {0, 0, 1}).done();
            return std::abs(one_estimate(s).r / s.expected.r - 1);
          }};
}

}  // namespace
}  // namespace grader::check
