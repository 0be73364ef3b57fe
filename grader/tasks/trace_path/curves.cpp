#include "grader/check/generators/generators.h"
#include "grader/check/language/curve.h"
#include "grader/check/language/property.h"
#include "grader/check/language/repeat.h"
#include "grader/tasks/trace_path/inputs.h"
#include "pt/tasks/trace_path.h"

#include <cmath>

namespace grader::check {
namespace {

using trace_path_inputs::settings_of;

Mean estimates(const Room& room, int draws, int bounces, double survival) {
  pt::PathSettings settings = settings_of({1, bounces}, room.direct);
  settings.survival = survival;
  return mean_of(repeat<pt::trace_path>(draws, *sampler_seed(), room.scene, room.point, settings));
}

// The room of these curves (grader/check/scenes/rooms.h): all directions of a path lead to the same wall, and
// hemisphere sampling has a variance of a third of the squared mean.
Room furnace_of(double albedo) {
  Place wall;
  wall.albedo = wall.direct = pt::gray(albedo);
  wall.variance_of_a_sample = pt::gray(albedo * albedo / 3);
  wall.leads = {1, 0, 0};
  Room room;
  room.places = {wall};
  return room;
}

// The standard deviation of one estimate over its mean, by the formula of grader/check/scenes/rooms.h.
double deviation_of(double albedo, int bounces, double survival) {
  const Room room = furnace_of(albedo);
  return deviation(room, settings_of({1, bounces}), {.survival = survival}).r /
         room.sum(1, bounces).r;
}

constexpr double kSurvival = 0.35;

// The contract allows twice the deviation of a survival of 0.3.
double allowed_deviation(double albedo, int bounces) {
  return 2 * deviation_of(albedo, bounces, 0.3);
}

// Returns the measured deviation.
double deviation_in_a_furnace(double albedo, int bounces, int draws) {
  const Room room = *glowing_room(rc::gen::just(pt::gray(albedo)));
  const Mean mean = estimates(room, draws, bounces, kSurvival);
  return mean.standard_error.r * std::sqrt(draws) / mean.value.r;
}

// A path survives k times with probability survival^k, and then carries (albedo / survival)^k. So
// the mean square of bounce k is (albedo^2 / survival)^k. For a base above 1 the sum has no limit.
CURVE(trace_path, bright_walls) {
  return {.title = "Roulette with survival 0.35 in a closed room, at most 20 bounces",
          .input = "squared albedo over survival",
          .error = "standard deviation of one estimate over its mean",
          .source = "above 1 the variance of a path without an end is infinite",
          .places = {0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 1, 1.1, 1.2, 1.5, 1.8, 2.2},
          .promised = {{0.1, 2.2,
                        [](double squared) {
                          return allowed_deviation(std::sqrt(squared * kSurvival), 20);
                        }}},
          .methods = {{"right/survival_by_throughput", "survives by its throughput"},
                      {"right/survival_by_albedo", "survives by the albedo"}},
          .statistic = Statistic::median,
          .cases = 3,
          .theory =
              [](double squared) {
                return deviation_of(std::sqrt(squared * kSurvival), 20, kSurvival);
              },
          .measure =
              [](double squared) {
                return deviation_in_a_furnace(std::sqrt(squared * kSurvival), 20, 4000);
              }};
}

// The formula counts paths so rare that no practical number of estimates has one.
CURVE(trace_path, long_paths) {
  return {
      .title = "Roulette with survival 0.35 in a closed room of albedo 0.75",
      .input = "bounces asked for",
      .error = "standard deviation of one estimate over its mean",
      .source = "each bounce multiplies the mean square by albedo squared over survival, 1.6",
      .places = {1, 2, 3, 5, 8, 12, 20, 30, 50, 100},
      .promised = {{1, 100,
                    [](double bounces) {
                      return allowed_deviation(0.75, static_cast<int>(bounces));
                    }}},
      .methods = {{"right/survival_by_throughput", "survives by its throughput"},
                  {"right/survival_by_albedo", "survives by the albedo"}},
      .statistic = Statistic::median,
      .cases = 3,
      .theory =
          [](double bounces) { return deviation_of(0.75, static_cast<int>(bounces), kSurvival); },
      .measure =
          [](double bounces) {
            return deviation_in_a_furnace(0.75, static_cast<int>(bounces), 4000);
          }};
}

// The median of the absolute error of a mean of so many estimates, for paths that survive by their
// throughput: 0.674 deviations of a normal distribution. This path carries 1 + a + B (1 + G) in units of
// its first bounce, where B is 1 with probability a^2, and G bounces follow with probability a each.
double usual_error_by_throughput(double albedo, double estimates) {
  const double deviation = albedo * std::sqrt(1 + albedo - albedo * albedo);
  return 0.674 * deviation / std::sqrt(estimates);
}

const double kBrightAlbedo = std::sqrt(1.8 * kSurvival);

// If the variance is finite, a hundred times the samples have a tenth of the error. If it has no
// limit, most means are too low, and some are far too high.
CURVE(trace_path, more_samples) {
  return {.title = "More samples, where squared albedo over survival is 1.8; survival 0.35",
          .input = "estimates in a mean, at most 100 bounces each",
          .error = "relative error of the mean",
          .source = "the law of large numbers gives 1 over a root only for a finite variance",
          .places = by_factors(30, 30000, 7),
          .promised = {},
          .methods = {{"right/survival_by_throughput", "survives by its throughput"},
                      {"right/survival_by_albedo", "survives by the albedo"}},
          .statistic = Statistic::median,
          .cases = 9,
          .theory =
              [](double estimates) { return usual_error_by_throughput(kBrightAlbedo, estimates); },
          .measure =
              [](double estimated) {
                constexpr int kBounces = 100;
                const Room room = *glowing_room(rc::gen::just(pt::gray(kBrightAlbedo)));
                const Mean mean = estimates(room, static_cast<int>(estimated), kBounces, kSurvival);
                return std::abs(mean.value.r / room.sum(1, kBounces).r - 1);
              }};
}

CURVE(trace_path, many_bounces) {
  return {.title = "A closed room with walls of albedo 0.99, without roulette",
          .input = "bounces asked for",
          .error = "the mean is off by this part",
          .source = "a limit for the number of bounces, or for the throughput",
          .places = {1, 2, 3, 5, 8, 10, 11, 16, 25, 40, 64, 100},
          .promised = {{1, 100, at_most(kColorPrecision)}},
          .methods = {{"wrong/cap_of_ten", "at most ten bounces"},
                      {"wrong/cap_of_fifty", "at most fifty bounces"}},
          .statistic = Statistic::bias,
          .cases = 30,
          .measure = [](double most) {
            const int bounces = static_cast<int>(most);
            const Room room = *glowing_room(rc::gen::just(pt::gray(0.99)));
            const double expected = room.sum(1, bounces).r;
            return estimates(room, 30, bounces, 1).value.r / expected - 1;
          }};
}

}  // namespace
}  // namespace grader::check
