#include "measure/scene/converge.h"

#include "measure/charts/gnuplot.h"
#include "measure/renders/rows.h"
#include "measure/renders/spec.h"
#include "measure/scene/options.h"
#include "pt/error.h"
#include "pt/render/choose_engine.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace measure::scene {

namespace {

using Direct = pt::PathSettings::Direct;

constexpr double kTime = 0.9;  // part of the time for the curves and the trials before

// The mean with weights of one over the squared errors.
Uncertain combined(const std::vector<Uncertain>& values) {
  double weights = 0, sum = 0;
  for (const Uncertain& each : values) {
    const double weight = 1 / (each.error * each.error);
    weights += weight;
    sum += weight * each.value;
  }
  return {sum / weights, 1 / std::sqrt(weights)};
}

Uncertain product(const Uncertain& error, double cost) {
  return {error.value * error.value * cost, 2 * error.error * error.value * cost};
}

void add_products(MethodCurve& curve) {
  std::vector<Uncertain> seconds, rays, samples;
  for (const Checked& point : curve.points) {
    seconds.push_back(product(point.error, point.seconds));
    rays.push_back(product(point.error, point.rays));
    samples.push_back(product(point.error, point.samples));
  }
  curve.error2_second = combined(seconds);
  curve.error2_ray = combined(rays);
  curve.error2_sample = combined(samples);
}

MethodCurve measured(Study& study, const Method& method, double part) {
  MethodCurve curve{method, {}, {}, {}, {}, {}, false, false};
  const Tried tried = study.try_out(method.way, {method.light_samples})[0];
  const Uncertain of_way = seen_bias(tried.bias2) ? tried.bias2 : Uncertain{};
  curve.heavy_tails = tried.variance.error > kHeavy * tried.variance.value;
  const pt::PathSettings path = path_of(method.way, method.light_samples);
  for (std::size_t i = 0; i < std::size(kSamples); ++i) {
    pt::RenderSettings settings{kSamples[i], {}, 0, 1};
    std::optional<Uncertain> bias2 = of_way;
    if (method.adaptive) {
      settings.adaptive = pt::AdaptiveSettings{kMaxAdaptive, kBatch, kTolerances[i]};
    }
    // A pixel may stop too early, which is a bias of these settings; other code may have a bias that the short renders hide.
    if (method.adaptive || study.has_reference()) bias2.reset();
    curve.points.push_back(study.check(path, settings, kSamples[i] * tried.seconds.value, bias2,
                                       part / std::size(kSamples)));
  }
  const double last = curve.points.back().error.value;
  curve.fails = of_way.value > last * last / 2;
  curve.slope = slope_of(curve.points);
  add_products(curve);
  return curve;
}

// The same pictures as those of the first curve, at the times of another engine.
MethodCurve by_engine(Study& study, const pt::View& view, const Method& method,
                      const MethodCurve& first) {
  pt::Scene other = view.scene;
  choose_engine(other, *method.engine, kMaxLeaf);
  const Uncertain factor = study.times_as_long(other, method.way, method.light_samples);
  MethodCurve curve = first;
  curve.method = method;
  for (Checked& point : curve.points) point.seconds *= factor.value;
  add_products(curve);
  curve.error2_second.error = std::hypot(curve.error2_second.error,
                                         curve.error2_second.value * factor.error / factor.value);
  return curve;
}

// Returns whether all tasks of the method are written: no stub was measured.
bool is_written(const Method& method) {
  Spec spec;
  spec.engine = method.engine.value_or(pt::Engine::wide);
  spec.path = path_of(method.way, method.light_samples);
  if (method.adaptive) spec.adaptive = pt::AdaptiveSettings{};
  const std::set<std::string> needed = tasks_used(spec);
  const std::vector<std::string> unwritten = unwritten_tasks();
  return std::none_of(unwritten.begin(), unwritten.end(),
                      [&](const std::string& task) { return needed.contains(task); });
}

// The error of a line after so many seconds; infinite where it has not begun or has ended.
double error_after(const std::vector<Checked>& line, double seconds) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i].seconds == seconds) return line[i].error.value;
    if (i == 0 || !(line[i - 1].seconds < seconds && seconds < line[i].seconds)) continue;
    const double part =
        std::log(seconds / line[i - 1].seconds) / std::log(line[i].seconds / line[i - 1].seconds);
    return line[i - 1].error.value * std::pow(line[i].error.value / line[i - 1].error.value, part);
  }
  return INFINITY;
}

}  // namespace

Uncertain ratio(const Uncertain& a, const Uncertain& b) {
  const double value = a.value / b.value;
  return {value, value * std::hypot(a.error / a.value, b.error / b.value)};
}

std::vector<Method> methods_in(const pt::Scene& scene, int bounces, pt::Engine engine) {
  const bool delta = std::all_of(scene.lights.begin(), scene.lights.end(), pt::is_delta);
  const bool some_delta = std::any_of(scene.lights.begin(), scene.lights.end(), pt::is_delta);
  const Way usual{Direct::lights, bounces, 0.7};
  std::vector<Method> all;
  for (const int l : {1, 2, 4, 8, 16, 32}) {
    if (l > 1 && delta) break;  // one sample is enough
    all.push_back({fmt::format("l{}", l), fmt::format("lights, l = {}", l), usual, l, false, {}});
  }
  const Way hemisphere{Direct::hemisphere, bounces, usual.survival};
  for (const int l : {1, 8, 32}) {
    if (some_delta && l > 1) break;  // a light without a surface is never met: one shows that
    all.push_back(
        {fmt::format("h{}", l), fmt::format("hemisphere, l = {}", l), hemisphere, l, false, {}});
  }
  for (const int percent : {30, 50, 85, 100}) {
    if (bounces <= 2) break;  // there is no roulette
    all.push_back({fmt::format("p{}", percent),
                   fmt::format("lights, l = 1, survival {:g}", percent / 100.0),
                   {Direct::lights, bounces, percent / 100.0},
                   1,
                   false,
                   {}});
  }
  all.push_back({"adaptive", "lights, l = 1, adaptive", usual, 1, true, {}});
  const std::pair<pt::Engine, const char*> engines[] = {{pt::Engine::wide, "the fast engine"},
                                                        {pt::Engine::task, "the tree of part 2"},
                                                        {pt::Engine::linear, "no tree"}};
  for (const auto& [other, title] : engines) {
    const bool slow = other == pt::Engine::linear && scene.primitives.size() > kMaxWithoutTree;
    if (other == engine || slow) continue;
    all.push_back({std::string(name(other)), fmt::format("lights, l = 1, {}", title), usual, 1,
                   false, other});
  }
  return all;
}

Uncertain slope_of(const std::vector<Checked>& points) {
  std::vector<LinePoint> logs;
  logs.reserve(points.size());
  for (const Checked& point : points) {
    const Uncertain& error = point.error;
    logs.push_back({std::log(point.samples), std::log(error.value), error.error / error.value});
  }
  const FreeLine fit = fit_free_line(logs);
  return {fit.line.slope, fit.slope_error};
}

void expect_method(const std::vector<Method>& methods, const std::string& title) {
  std::vector<std::string> titles;
  titles.reserve(methods.size());
  for (const Method& method : methods) titles.push_back(method.title);
  if (title.empty() || std::find(titles.begin(), titles.end(), title) != titles.end()) return;
  throw pt::Error(fmt::format("--beside: there is no method '{}' here, but these: \"{}\"", title,
                              fmt::join(titles, "\", \"")));
}

std::vector<MethodCurve> find_curves(Study& study, const pt::View& view,
                                     const std::vector<Method>& methods) {
  std::vector<MethodCurve> curves;
  for (const Method& method : methods) {
    const double part = kTime / 2 / static_cast<double>(methods.size());
    MethodCurve curve =
        method.engine ? by_engine(study, view, method, curves[0]) : measured(study, method, part);
    if (is_written(method)) curves.push_back(std::move(curve));
  }
  return curves;
}

Factors factors(const MethodCurve& curve, const MethodCurve& beside) {
  const Uncertain time = ratio(curve.error2_second, beside.error2_second);
  const double root = std::sqrt(time.value);
  return {time, {root, time.error / (2 * root)}, ratio(curve.error2_ray, beside.error2_ray)};
}

std::vector<Efficiency> efficiencies(const MethodCurve& curve, const MethodCurve& first) {
  std::vector<Efficiency> all;
  for (const Checked& point : curve.points) {
    all.push_back({point.seconds, ratio(first.error2_second, product(point.error, point.seconds))});
  }
  return all;
}

std::vector<DrawnMethod> seven_of(const std::vector<MethodCurve>& curves) {
  const MethodCurve& first = curves[0];
  std::vector<const MethodCurve*> others, hemisphere, survivals;
  std::vector<DrawnMethod> chosen{{&first, ink::kBlack}};
  const MethodCurve *adaptive = nullptr, *engine = nullptr;
  for (const MethodCurve& curve : curves) {
    const Method& method = curve.method;
    if (&curve == &first) continue;
    if (method.adaptive) {
      adaptive = &curve;
    } else if (method.engine) {
      engine = engine == nullptr ? &curve : engine;
    } else if (method.way.direct == Direct::hemisphere) {
      hemisphere.push_back(&curve);
    } else {
      (method.way == first.method.way ? others : survivals).push_back(&curve);
    }
  }
  const auto cost = [](const MethodCurve* curve) { return curve->error2_second.value; };
  const auto add_cheapest = [&](const std::vector<const MethodCurve*>& group, const char* color) {
    if (!group.empty()) chosen.push_back({*std::ranges::min_element(group, {}, cost), color});
  };
  add_cheapest(others, ink::kSky);
  if (others.size() > 1) {
    chosen.push_back({*std::ranges::max_element(others, {}, cost), ink::kPink});
  }
  add_cheapest(hemisphere, ink::kVermilion);
  add_cheapest(survivals, ink::kGreen);
  if (adaptive != nullptr) chosen.push_back({adaptive, ink::kBlue});
  if (engine != nullptr) chosen.push_back({engine, ink::kOrange});
  return chosen;
}

std::vector<FrontPlace> front_of(const std::vector<MethodCurve>& curves) {
  std::vector<std::vector<Checked>> lines;
  std::vector<double> times;
  for (const MethodCurve& curve : curves) {
    if (curve.fails) continue;
    lines.push_back(curve.points);
    std::ranges::sort(lines.back(), {}, &Checked::seconds);
    for (const Checked& point : curve.points) times.push_back(point.seconds);
  }
  const auto [first, last] = std::ranges::minmax(times);
  constexpr int kSteps = 200;
  for (int i = 1; i < kSteps; ++i) {
    times.push_back(first * std::pow(last / first, static_cast<double>(i) / kSteps));
  }
  std::ranges::sort(times);
  std::vector<FrontPlace> front;
  for (const double seconds : times) {
    double least = INFINITY;
    for (const std::vector<Checked>& line : lines)
      least = std::min(least, error_after(line, seconds));
    if (front.empty() || least < front.back().error) front.push_back({seconds, least});
  }
  return front;
}

const MethodCurve& fastest(const std::vector<MethodCurve>& curves) {
  return *std::ranges::min_element(curves, {}, [](const MethodCurve& curve) {
    return std::pair(curve.fails, curve.error2_second.value);
  });
}

}  // namespace measure::scene
