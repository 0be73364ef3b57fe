#include "writeup/accuracy/converge.h"

#include "pt/file.h"
#include "writeup/gnuplot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace writeup::accuracy {

namespace {

using Direct = pt::PathSettings::Direct;

constexpr int kSamples[] = {4, 16, 64, 256};
constexpr double kTolerances[] = {0.8, 0.4, 0.2, 0.1};
constexpr int kMostAdaptive = 4096;
constexpr int kBatch = 16;
constexpr double kSurvival = 0.7;  // where nothing else is said
constexpr double kTime = 0.9;      // of the whole, for the curves and what is tried before them
constexpr double kHeavy = 0.1;     // of the variance, that its own error may be

std::vector<Method> methods(const pt::Scene& scene, int bounces) {
  const bool delta = std::all_of(scene.lights.begin(), scene.lights.end(), pt::is_delta);
  const bool some_delta = std::any_of(scene.lights.begin(), scene.lights.end(), pt::is_delta);
  std::vector<Method> all;
  const auto add = [&](const std::string& title, Direct direct, int l, double survival,
                       bool adaptive) {
    all.push_back({title, {direct, bounces, survival}, l, adaptive});
  };
  for (const int l : {1, 2, 4, 8, 16, 32}) {
    if (l == 1 || !delta)
      add(fmt::format("lights, l = {}", l), Direct::lights, l, kSurvival, false);
  }
  // What has no surface is never met by chance.
  for (const int l : {1, 8, 32}) {
    if (!some_delta)
      add(fmt::format("hemisphere, l = {}", l), Direct::hemisphere, l, kSurvival, false);
  }
  for (const double survival : {0.3, 0.5, 0.85, 1.0}) {
    if (bounces <= 2) break;  // there is no roulette
    add(fmt::format("lights, l = 1, survival {:g}", survival), Direct::lights, 1, survival, false);
  }
  add("lights, l = 1, adaptive", Direct::lights, 1, kSurvival, true);
  return all;
}

// The mean with weights that are one over the squares of the errors.
Uncertain combined(const std::vector<Uncertain>& values) {
  double weights = 0, sum = 0;
  for (const Uncertain& each : values) {
    const double weight = 1 / (each.error * each.error);
    weights += weight;
    sum += weight * each.value;
  }
  return {sum / weights, 1 / std::sqrt(weights)};
}

Curve measured(Study& study, const Method& method, double part) {
  Curve curve{method, {}, {}, {}, false};
  const Tried tried = study.try_out(method.way, {method.light_samples})[0];
  curve.heavy_tails = tried.variance.error > kHeavy * tried.variance.value;
  const pt::PathSettings path = path_of(method.way, method.light_samples);
  std::vector<Uncertain> products;
  for (std::size_t i = 0; i < std::size(kSamples); ++i) {
    pt::RenderSettings settings{kSamples[i], {}, 0, 1};
    double seconds = kSamples[i] * tried.seconds.value;
    if (method.adaptive) {
      settings.adaptive = pt::AdaptiveSettings{kMostAdaptive, kBatch, kTolerances[i]};
    }
    const Checked point = study.check(path, settings, seconds, 0, part / std::size(kSamples));
    curve.points.push_back(point);
    const double square = point.error.value * point.error.value;
    products.push_back(
        {square * point.seconds, 2 * point.error.error * point.error.value * point.seconds});
  }
  curve.slope = slope_of(curve.points);
  curve.error2_second = combined(products);
  return curve;
}

std::string percent(double part) { return fmt::format("{:.3g} %", 100 * part); }

// Where each pixel has a number of samples of its own, there is no slope to speak of.
std::string slope_text(const Curve& curve) {
  if (curve.method.adaptive) return fmt::format("{:>15}", "-");
  return fmt::format("{:>7.3f} \u00b1 {:.3f}", curve.slope.value, curve.slope.error);
}

std::string row(const Curve& curve, double best) {
  std::string text = fmt::format("  {:<30}", curve.method.title);
  for (const Checked& point : curve.points) {
    text += fmt::format("{:>10}", percent(point.error.value));
  }
  return text + fmt::format("  {} {:>8.3g}{}\n", slope_text(curve),
                            curve.error2_second.value / best,
                            curve.heavy_tails ? "  heavy tails" : "");
}

const char* const kChart = R"gp(set logscale xy
set xlabel "{}"
set ylabel "error (root of relMSE)"
set key outside right
plot {}
)gp";

// Blue: light sampling; green: other chances of survival; red: hemisphere sampling; black: adaptive.
std::string plot(const std::vector<Curve>& curves, int column) {
  std::string text;
  int used[3] = {0, 0, 0};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Method& method = curves[i].method;
    const Hue hue = method.way.direct == Direct::hemisphere ? Hue::red
                    : method.way.survival != kSurvival      ? Hue::green
                                                            : Hue::blue;
    const std::string ink = method.adaptive ? "#000000" : color(hue, used[static_cast<int>(hue)]++);
    text += fmt::format(
        "{}\"converge.csv\" index {} using {}:6:7 with yerrorlines lc rgb \"{}\" lw 1.5 pt 7 ps .4 "
        "title \"{}\"",
        i == 0 ? "" : ", ", i, column, ink, method.title);
  }
  return text;
}

}  // namespace

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

std::vector<Curve> find_curves(Study& study, const pt::Scene& scene, int bounces) {
  const std::vector<Method> all = methods(scene, bounces);
  std::vector<Curve> curves;
  curves.reserve(all.size());
  for (const Method& method : all) {
    curves.push_back(measured(study, method, kTime / 2 / static_cast<double>(all.size())));
  }
  return curves;
}

std::string to_text(const std::vector<Curve>& curves, const Options& options) {
  double best = curves[0].error2_second.value;
  for (const Curve& curve : curves) best = std::min(best, curve.error2_second.value);
  std::string text = fmt::format(
      "{}, {} x {} pixels, at most {} bounces: the error, and the time for the same error\n\n  "
      "{:<30}",
      options.scene.string(), options.width, options.height, options.bounces, "");
  for (const int samples : kSamples) text += fmt::format("{:>10}", fmt::format("s = {}", samples));
  text += fmt::format("  {:>15} {:>8}\n", "slope", "time");
  for (const Curve& curve : curves) text += row(curve, best);
  text += fmt::format(
      "\nAdaptive sampling: batches of {}, at most {} samples, tolerances {:g}, {:g}, {:g}, {:g} "
      "in place of s.\n"
      "The slope is that of log error over log samples: -0.5 where samples are independent.\n"
      "At equal time, errors are as the roots of the last column.\n",
      kBatch, kMostAdaptive, kTolerances[0], kTolerances[1], kTolerances[2], kTolerances[3]);
  return text;
}

void write_curves(const std::vector<Curve>& curves, const Options& options,
                  const std::filesystem::path& folder) {
  const double pixels = static_cast<double>(options.width) * options.height;
  std::string csv = "method,light_samples,samples,seconds,rays,error,error_of_it\n";
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (i > 0) csv += "\n\n";
    for (const Checked& point : curves[i].points) {
      csv += fmt::format("\"{}\",{},{:.6g},{:.6g},{:.6g},{:.6g},{:.3g}\n", curves[i].method.title,
                         curves[i].method.light_samples, point.samples, point.seconds * pixels,
                         point.rays * pixels, point.error.value, point.error.error);
    }
  }
  pt::write_file(folder / "converge.csv", csv);
  const std::pair<const char*, const char*> axes[] = {
      {"samples", "samples per pixel"}, {"seconds", "processor seconds"}, {"rays", "rays"}};
  for (int i = 0; i < 3; ++i) {
    draw(folder, axes[i].first,
         fmt::format(fmt::runtime(kChart), axes[i].second, plot(curves, 3 + i)));
  }
}

}  // namespace writeup::accuracy
