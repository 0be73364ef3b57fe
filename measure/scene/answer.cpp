#include "measure/scene/answer.h"

#include "measure/scene/adaptive.h"
#include "pt/error.h"
#include "pt/render/choose_engine.h"
#include "pt/tasks/camera_ray.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace measure::scene {

namespace {

using Direct = pt::PathSettings::Direct;

const Way kCourse{};
constexpr int kCourseLightSamples = 4;

constexpr double kMaxBias = 0.1;      // of error^2: below that, bounces cost more than they gain
constexpr double kWorthTrying = 0.7;  // of error^2: with more bias there is no room for noise
constexpr int kFewerBounces = 3;      // smaller numbers that are tried
constexpr double kFlat = 0.99985;     // cosine of 1 degree

Option look_at(Study& study, const Way& way, const std::vector<int>& light_samples, double bias2,
               double error) {
  Option option{way, study.try_out(way, light_samples), {}, {}};
  option.model = model_of(option.tried, bias2);
  option.choice = cheapest_choice(option.model, error);
  return option;
}

// If the best number of light samples is beyond the tried numbers, it is tried too: a line is less
// certain outside its points.
void try_the_best(Study& study, Option& option, double error) {
  if (!option.choice || option.choice->light_samples <= option.tried.back().light_samples) return;
  option.tried.push_back(study.try_out(option.way, {option.choice->light_samples})[0]);
  option.model = model_of(option.tried, option.model.bias2);
  option.choice = cheapest_choice(option.model, error);
}

// Two numbers of light samples, for ways that differ from a known way in another setting.
std::vector<int> pair_beside(const Option& known, bool delta_lights) {
  if (delta_lights) return {1, 2};
  return {1, std::max(kCourseLightSamples, known.choice ? known.choice->light_samples : 1)};
}

bool is_better(const Option& a, const Option& b) {
  return a.choice && (!b.choice || a.choice->seconds < b.choice->seconds);
}

int bounces_needed(const Study& study, double error) {
  for (int m = 1; m <= kToldApart; ++m) {
    if (study.bias2_at(m) <= kMaxBias * error * error) return m;
  }
  return kAllBounces;
}

// It misses lights without a surface, which is a bias: no number of samples helps.
Option look_at_hemisphere(Study& study, const Way& way, double bias2, double error) {
  Option option =
      look_at(study, {Direct::hemisphere, way.bounces, way.survival}, {1, 8}, bias2, error);
  const Uncertain& seen = option.tried.back().bias2;
  if (seen.value > bias2 + kSignificant * seen.error) {
    option.model.bias2 = seen.value;
    option.choice = cheapest_choice(option.model, error);
  }
  try_the_best(study, option, error);
  return option;
}

std::optional<AdaptiveOption> look_at_adaptive(Study& study, const Option& best, double error) {
  const Choice& choice = *best.choice;
  if (choice.samples < 16) return std::nullopt;
  const int batch = std::clamp(choice.samples / 8, 4, 32);
  pt::AdaptiveSettings settings{std::min(16 * choice.samples, kMaxSamples), batch, 0.05};
  const std::vector<Study::PixelNoise> noise = study.pixel_noise(best.way, choice.light_samples);
  const double left = error * error - best.model.bias2;
  settings.tolerance = tolerance_for(noise, settings, left);
  const pt::PathSettings path = path_of(best.way, choice.light_samples);
  AdaptiveOption option{
      settings, study.check(path, {1, settings, 0, 1}, choice.seconds, best.model.bias2), 1};
  // The variance of a mean of n samples falls as 1 / n, also where n depends on the pixel.
  const double variance =
      std::max(option.checked.error.value * option.checked.error.value - best.model.bias2, 0.0);
  option.times = option.checked.seconds * variance / left / choice.seconds;
  return option;
}

double part_with_smooth_normals(const pt::View& view) {
  long long smooth = 0;
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const pt::Ray ray = camera_ray(view.camera, (x + 0.5) / view.width, (y + 0.5) / view.height);
      const std::optional<pt::Hit> hit = view.scene.closest(ray);
      if (!hit || !view.scene.primitives.is_triangle(hit->primitive)) continue;
      const pt::SurfacePoint point = surface_point(view.scene, ray, *hit);
      if (std::abs(dot(point.n, point.geometric_normal)) < kFlat) ++smooth;
    }
  }
  return static_cast<double>(smooth) / (static_cast<double>(view.width) * view.height);
}

std::optional<Uncertain> look_without_tree(Study& study, const pt::View& view, const Option& best) {
  if (view.scene.primitives.size() > kMaxWithoutTree) return std::nullopt;
  pt::Scene linear = view.scene;
  choose_engine(linear, pt::Engine::linear, 4);
  return study.times_as_long(linear, best.way, best.choice->light_samples);
}

void choose_survival(Study& study, Answer& answer, double bias2, const std::vector<int>& pair) {
  if (answer.best.way.bounces <= 2) return;  // there is no roulette
  for (const double survival : {0.3, 0.5, 0.85, 1.0}) {
    answer.survivals.push_back(look_at(study, {Direct::lights, answer.best.way.bounces, survival},
                                       pair, bias2, answer.error));
    if (is_better(answer.survivals.back(), answer.best)) answer.best = answer.survivals.back();
  }
}

void choose_bounces(Study& study, Answer& answer, const std::vector<int>& pair) {
  const Way way = answer.best.way;
  const int most = std::min(way.bounces, kToldApart + 1);
  for (int m = most - 1; m >= std::max(1, most - kFewerBounces); --m) {
    const double bias2 = study.bias2_at(m);
    if (bias2 > kWorthTrying * answer.error * answer.error) break;
    answer.bounces.push_back(
        look_at(study, {Direct::lights, m, way.survival}, pair, bias2, answer.error));
    if (is_better(answer.bounces.back(), answer.best)) answer.best = answer.bounces.back();
  }
}

}  // namespace

bool is_unwritten(const Answer& answer, const std::string& task) {
  const std::vector<std::string>& tasks = answer.unwritten;
  return std::find(tasks.begin(), tasks.end(), task) != tasks.end();
}

Answer find_cheapest(Study& study, const pt::View& view, const Options& options) {
  Answer answer;
  const double error = options.error;
  answer.error = error;
  answer.bias2 = study.bias2();
  answer.delta_lights =
      std::all_of(view.scene.lights.begin(), view.scene.lights.end(), pt::is_delta);
  const std::vector<int> tried = answer.delta_lights ? std::vector{1, 2} : options.light_samples;

  const int bounces = bounces_needed(study, error);
  const double bias2 = study.bias2_at(bounces);
  answer.best = look_at(study, {Direct::lights, bounces, kCourse.survival}, tried, bias2, error);
  if (!answer.delta_lights) try_the_best(study, answer.best, error);
  const std::vector<int> pair = pair_beside(answer.best, answer.delta_lights);
  answer.survivals.push_back(answer.best);
  choose_survival(study, answer, bias2, pair);
  choose_bounces(study, answer, pair);
  answer.hemisphere = look_at_hemisphere(study, answer.best.way, answer.best.model.bias2, error);
  answer.unwritten = unwritten_tasks();
  if (is_unwritten(answer, "direct_hemisphere")) answer.hemisphere.choice.reset();
  if (is_better(answer.hemisphere, answer.best)) answer.best = answer.hemisphere;
  if (!answer.best.choice) {
    throw pt::Error(
        fmt::format("an error of {:g} % needs more than {} samples per pixel; ask for a larger one "
                    "with --error",
                    100 * error, kMaxSamples));
  }
  answer.course = bounces == kCourse.bounces
                      ? answer.survivals[0]
                      : look_at(study, kCourse, pair, study.bias2_at(kCourse.bounces), error);
  answer.course.choice = cheapest_choice_with(answer.course.model, error, kCourseLightSamples);

  const Choice& choice = *answer.best.choice;
  answer.checked = study.check(path_of(answer.best.way, choice.light_samples),
                               {choice.samples, {}, 0, 1}, choice.seconds, answer.best.model.bias2);
  answer.adaptive = look_at_adaptive(study, answer.best, error);
  answer.unwritten = unwritten_tasks();
  if (is_unwritten(answer, "adaptive_pixel")) answer.adaptive.reset();
  answer.without_tree = look_without_tree(study, view, answer.best);
  answer.cpu_seconds = study.cpu_seconds();
  answer.smooth = part_with_smooth_normals(view);
  return answer;
}

}  // namespace measure::scene
