#include "measure/scene/answer.h"

#include "measure/charts/numbers.h"
#include "measure/renders/rows.h"
#include "measure/scene/adaptive.h"
#include "pt/error.h"
#include "pt/render/choose_engine.h"
#include "pt/tasks/camera_ray.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace measure::scene {

namespace {

using Direct = pt::PathSettings::Direct;

const Way kCourse{};
constexpr int kCourseLightSamples = 4;

constexpr double kMaxBias = 0.1;      // of error^2: below that, bounces cost more than they gain
constexpr double kWorthTrying = 0.7;  // of error^2: with more bias there is no room for noise
constexpr int kFewerBounces = 3;      // smaller numbers that are tried
constexpr double kFlat = 0.99985;     // cosine of 1 degree

constexpr double kGain = 0.03;  // of the price: a promise of the model that is worth a render
constexpr int kMaxFurther = 2;  // such renders per way

// `bias2` is what the number of bounces leaves out. Hemisphere sampling also misses lights without a
// surface, and code beside the reference may have any mistake: no number of samples helps.
Option look_at(Study& study, const Way& way, const std::vector<int>& light_samples, double bias2,
               double error) {
  const std::vector<Tried> tried = study.try_out(way, light_samples);
  const bool may_be_wrong = study.has_reference() || way.direct == Direct::hemisphere;
  const Uncertain& seen = tried.back().bias2;
  const bool is_wrong = may_be_wrong && seen.value > bias2 + kSignificant * seen.error;
  return option_of(way, tried, is_wrong ? seen.value : bias2, error);
}

// The model may promise a cheaper number of light samples between those that were measured, or
// beyond. Its lines are approximate, so that number is measured before it can be the answer.
Option refined(Study& study, Option option, double error) {
  for (int i = 0; i < kMaxFurther; ++i) {
    const std::optional<int> l = worth_measuring(option.tried, option.model, kGain);
    if (!l) break;
    option.tried.push_back(study.try_out(option.way, {*l})[0]);
    std::ranges::sort(option.tried, {}, &Tried::light_samples);
    option = option_of(option.way, option.tried, option.model.bias2, error);
  }
  return option;
}

// Two numbers of light samples for ways that differ from a known way in another setting: the best
// of that, and the course's.
std::vector<int> pair_beside(const Option& known, bool delta_lights) {
  if (delta_lights) return {1};
  const int best = known.choice ? known.choice->light_samples : 1;
  if (best == kCourseLightSamples) return {1, best};
  return {std::min(best, kCourseLightSamples), std::max(best, kCourseLightSamples)};
}

// "3 hours of one processor".
std::string duration(double seconds) {
  const std::pair<double, const char*> units[] = {
      {365.25 * 86400, "years"}, {86400, "days"}, {3600, "hours"}, {60, "minutes"}};
  for (const auto& [unit, name] : units) {
    if (seconds > 2 * unit) return fmt::format("{:.2g} {} of one processor", seconds / unit, name);
  }
  return fmt::format("{:.2g} seconds of one processor", seconds);
}

int bounces_needed(const Study& study, double error) {
  for (int m = 1; m <= kToldApart; ++m) {
    if (study.bias2_at(m) <= kMaxBias * error * error) return m;
  }
  return kAllBounces;
}

Option look_at_hemisphere(Study& study, const Way& way, double bias2, double error) {
  Option option =
      look_at(study, {Direct::hemisphere, way.bounces, way.survival}, {1, 8}, bias2, error);
  return option.choice ? refined(study, option, error) : option;
}

// The course's number of light samples; with delta lights, one is as good.
std::vector<Tried>::const_iterator find_course(const std::vector<Tried>& tried, bool delta_lights) {
  const int l = delta_lights ? 1 : kCourseLightSamples;
  return std::ranges::find(tried, l, &Tried::light_samples);
}

Option look_at_course(Study& study, const Answer& answer, const std::vector<int>& pair,
                      double error) {
  const Option& first = answer.survivals[0];
  const bool known =
      first.way == kCourse && find_course(first.tried, answer.delta_lights) != first.tried.end();
  return known ? first : look_at(study, kCourse, pair, study.bias2_at(kCourse.bounces), error);
}

double relative_price_error(const Option& option) {
  const auto chosen =
      std::ranges::find(option.tried, option.choice->light_samples, &Tried::light_samples);
  const Uncertain of_it = price(*chosen);
  return of_it.value > 0 ? of_it.error / of_it.value : 0;
}

// The settings whose picture has the error. Noise alone predicts the first try; pixels that stop too
// early add a bias, and the second try makes up for it. There is none where the first took twice the
// samples of uniform sampling: adaptive sampling does not pay there, and the second would take longer.
std::optional<AdaptiveOption> look_at_adaptive(Study& study, const Option& best, double error) {
  const Choice& choice = *best.choice;
  if (choice.samples < 16) return std::nullopt;
  const int batch = std::clamp(choice.samples / 8, 4, 32);
  pt::AdaptiveSettings settings{std::min(16 * choice.samples, kMaxSamples), batch, 0.05};
  const std::vector<Study::PixelNoise> noise = study.pixel_noise(best.way, choice.light_samples);
  const double left = error * error - best.model.bias2;
  settings.tolerance = tolerance_for(noise, settings, left);
  const pt::PathSettings path = path_of(best.way, choice.light_samples);
  const auto check = [&] { return study.check(path, {1, settings, 0, 1}, choice.seconds, {}); };
  Checked checked = check();
  if (checked.samples < 2 * choice.samples && checked.error.value > error) {
    settings.tolerance *= error / checked.error.value;
    checked = check();
  }
  AdaptiveOption option{settings, checked, {}, {}};
  // The rest between the two errors: error^2 falls as 1 / time, about.
  const Uncertain& seen = option.checked.error;
  const double times = option.checked.seconds / choice.seconds * std::pow(seen.value / error, 2);
  const double of_error = seen.value > 0 ? 2 * seen.error / seen.value : 0;
  option.times = {times, times * std::hypot(of_error, relative_price_error(best))};
  std::vector<double> squares;
  for (const Study::PixelNoise& pixel : noise) {
    squares.push_back(pixel.relative / option.checked.samples);
  }
  option.uniform = pt::pixel_errors(std::move(squares));
  option.best_possible = best_possible(noise);
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
  }
  answer.best = cheapest_of(answer.survivals, answer.best);
}

void choose_bounces(Study& study, Answer& answer, const std::vector<int>& pair) {
  const Way way = answer.best.way;
  const int most = std::min(way.bounces, kToldApart + 1);
  for (int m = most - 1; m >= std::max(1, most - kFewerBounces); --m) {
    const double bias2 = study.bias2_at(m);
    if (bias2 > kWorthTrying * answer.error * answer.error) break;
    answer.bounces.push_back(
        look_at(study, {Direct::lights, m, way.survival}, pair, bias2, answer.error));
  }
  answer.best = cheapest_of(answer.bounces, answer.best);
}

// A sentence for each way whose bias beside the reference is more than its bounces leave out.
std::vector<std::string> what_is_wrong(const Study& study, const Answer& answer) {
  std::vector<std::string> sentences;
  const auto add = [&](const char* name, const Option& option) {
    const double bias2 = option.model.bias2;
    if (!study.has_reference() || !(bias2 > study.bias2_at(option.way.bounces))) return;
    sentences.push_back(fmt::format(
        "{} is off by {} beside the reference, with any number of samples: ./run grade says what "
        "is wrong",
        name, percent(std::sqrt(bias2))));
  };
  add("light sampling", answer.survivals[0]);
  add("hemisphere sampling", answer.hemisphere);
  return sentences;
}

}  // namespace

Uncertain times_as_long(const Option& option, const Option& best) {
  const double times = option.choice->seconds / best.choice->seconds;
  const bool same =
      option.way == best.way && option.choice->light_samples == best.choice->light_samples;
  return {times,
          same ? 0 : times * std::hypot(relative_price_error(option), relative_price_error(best))};
}

Option option_of(const Way& way, std::vector<Tried> tried, double bias2, double error) {
  Option option{way, std::move(tried), {}, {}};
  option.model = model_of(option.tried, bias2);
  option.choice = cheapest_choice(option.tried, bias2, error);
  return option;
}

Option cheapest_of(const std::vector<Option>& others, Option best) {
  for (const Option& other : others) {
    if (!other.choice) continue;
    if (!best.choice || other.choice->seconds < best.choice->seconds) best = other;
  }
  return best;
}

void expect_reachable(const Tried& tried, double error, double pixels) {
  constexpr double kMaxSeconds = 120;  // of the check, on its fewest pixels in two pictures
  const double samples = tried.variance.value / (error * error);
  const double check = 2 * kFewestPixels * samples * tried.seconds.value;
  if (samples <= kMaxSamples && check <= kMaxSeconds) return;
  const double least = std::sqrt(tried.variance.value / kMaxSamples);
  const std::string why =
      samples > kMaxSamples
          ? fmt::format("the most that can be rendered is {}, for an error of about {:.2g} %",
                        kMaxSamples, 100 * least)
          : fmt::format("the check on {} pixels alone would take {}", kFewestPixels,
                        duration(check));
  throw pt::Error(fmt::format(
      "an error of {:.2g} % would take {:.2g} samples per pixel, {}; {}: ask for a larger error "
      "with --error",
      100 * error, samples, duration(samples * tried.seconds.value * pixels), why));
}

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
  const std::vector<int> tried = answer.delta_lights ? std::vector{1} : options.light_samples;

  const int bounces = bounces_needed(study, error);
  const double bias2 = study.bias2_at(bounces);
  answer.best = look_at(study, {Direct::lights, bounces, kCourse.survival}, tried, bias2, error);
  if (!answer.delta_lights) answer.best = refined(study, answer.best, error);
  const std::vector<int> pair = pair_beside(answer.best, answer.delta_lights);
  answer.survivals.push_back(answer.best);
  choose_survival(study, answer, bias2, pair);
  choose_bounces(study, answer, pair);
  answer.hemisphere =
      look_at_hemisphere(study, answer.best.way, study.bias2_at(answer.best.way.bounces), error);
  answer.unwritten = unwritten_tasks();
  if (is_unwritten(answer, "direct_hemisphere")) answer.hemisphere.choice.reset();
  answer.course = look_at_course(study, answer, pair, error);
  answer.best = cheapest_of({answer.hemisphere, answer.course}, answer.best);
  answer.wrong = what_is_wrong(study, answer);
  if (!answer.best.choice)
    throw WrongBesideReference(fmt::format("{}", fmt::join(answer.wrong, "; ")));
  expect_reachable(cheapest_of(answer.best.tried), error,
                   static_cast<double>(view.width) * view.height);
  answer.course.choice = choice_with(*find_course(answer.course.tried, answer.delta_lights),
                                     answer.course.model.bias2, error);

  const Choice& choice = *answer.best.choice;
  std::optional<Uncertain>
      known;  // what the bounces leave out; other code may have a bias of its own
  if (!study.has_reference()) known = Uncertain{answer.best.model.bias2, 0};
  answer.checked = study.check(path_of(answer.best.way, choice.light_samples),
                               {choice.samples, {}, 0, 1}, choice.seconds, known);
  answer.adaptive = look_at_adaptive(study, answer.best, error);
  answer.unwritten = unwritten_tasks();
  if (is_unwritten(answer, "adaptive_pixel")) answer.adaptive.reset();
  answer.without_tree = look_without_tree(study, view, answer.best);
  answer.cpu_seconds = study.cpu_seconds();
  answer.smooth = part_with_smooth_normals(view);
  return answer;
}

}  // namespace measure::scene
