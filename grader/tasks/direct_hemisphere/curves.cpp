#include "grader/check/generators/generators.h"
#include "grader/check/language/curve.h"
#include "grader/check/language/property.h"
#include "grader/check/language/repeat.h"
#include "grader/check/scenes/scenes.h"
#include "pt/tasks/direct_hemisphere.h"

#include <cmath>

namespace grader::check {
namespace {

// The relative deviation of one estimate below a ball of light that fills a cone around the normal, whose
// half angle has the sine `radius` and the cosine c: uniform directions have a mean cosine of radius^2 / 2
// over the hemisphere, and a mean squared cosine of (1 - c^3) / 3.
double deviation_below_a_ball(double radius) {
  const double c = std::sqrt((1 - radius) * (1 + radius));
  return std::sqrt(4 * (1 - c * c * c) / (3 * std::pow(radius, 4)) - 1);
}

// The deviation is measured with some hundred directions that meet the light.
constexpr double kSlack = 1.15;

// A direction meets the light with a probability of its solid angle over 2 pi. For a small light
// the deviation is about sqrt(2 pi / solid angle).
CURVE(direct_hemisphere, small_light) {
  return {.title = "A light that is small or far away",
          .input = "radius of the light over its distance",
          .error = "standard deviation of one estimate over its mean",
          .source = "the chance to meet it is its solid angle over 2 pi",
          .places = by_factors(0.9, 0.02, 9),
          // The contract allows the deviation of uniform directions.
          .promised = {{0.9, 0.02,
                        [](double radius) { return kSlack * deviation_below_a_ball(radius); }}},
          .methods = {{"right/stratified", "stratified directions"},
                      {"methods/light_sampling", "light sampling"}},
          .statistic = Statistic::median,
          .cases = 3,
          .theory = deviation_below_a_ball,
          .measure = [](double radius) {
            SceneMaker maker(*unturned_pose());
            maker.ball({0, 0, 1}, radius, pt::gray(1), Body::surface);
            const Situation s = maker.patch(pt::gray(0.5), {0, 0, 1}).done();
            // Some hundred directions meet the light.
            const int draws = static_cast<int>(400 / (radius * radius));
            const Mean mean =
                mean_of(repeat<pt::direct_hemisphere>(draws, *sampler_seed(), s.scene, s.point, 1));
            return mean.standard_error.r * std::sqrt(draws) / mean.value.r;
          }};
}

// A disk of light around the normal, seen with the same random numbers.
double mean_below_a_disk(pt::Vec3 n, std::uint64_t seed) {
  constexpr int kDraws = 4000;
  SceneMaker maker({pt::frame_from_normal(n), {}, 1});
  maker.ball({0, 0, 1}, 0.7, pt::gray(1), Body::surface);
  const Situation s = maker.patch(pt::gray(0.5), {0, 0, 1}).done();
  return mean_of(repeat<pt::direct_hemisphere>(kDraws, seed, s.scene, s.point, 1)).value.r;
}

// Axes that are not orthogonal, or too long, move directions towards the disk or away from it. The same
// numbers with the normal +z, where no frame has difficulties, cancel the noise of most methods.
CURVE(direct_hemisphere, normal_near_minus_z) {
  return {.title = "A normal that is almost -z",
          .input = "angle between the normal and -z, in radians",
          .error = "the mean is off by this part, beside the same numbers with the normal +z",
          .source = "Duff et al. 2017, Building an Orthonormal Basis, Revisited, JCGT 6(1)",
          .places = by_factors(1e-1, 1e-5, 25),
          .promised = {{1e-1, 1e-5, at_most(kColorPrecision)}},
          .methods = {{"methods/frame_frisvad", "Frisvad 2012"},
                      {"methods/frame_frisvad", "Frisvad 2012, single precision", true},
                      {"methods/frame_duff", "Duff 2017, single precision", true}},
          .statistic = Statistic::bias,
          .cases = 30,
          .measure = [](double angle) {
            const double phi = *real(-pt::kPi, pt::kPi);
            const pt::Vec3 n{std::sin(angle) * std::cos(phi), std::sin(angle) * std::sin(phi),
                             -std::cos(angle)};
            const std::uint64_t seed = *sampler_seed();
            return mean_below_a_disk(n, seed) / mean_below_a_disk({0, 0, 1}, seed) - 1;
          }};
}

}  // namespace
}  // namespace grader::check
