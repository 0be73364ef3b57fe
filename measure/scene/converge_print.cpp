#include "measure/charts/gnuplot.h"
#include "measure/scene/converge.h"
#include "measure/scene/print.h"
#include "pt/file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace measure::scene {

namespace {

using Direct = pt::PathSettings::Direct;

// A method with another number of samples in each pixel has no slope.
std::string slope_text(const MethodCurve& curve) {
  if (curve.method.adaptive) return fmt::format("{:>14}", "-");
  return fmt::format("{:>6.3f} \u00b1 {:.3f}", curve.slope.value, curve.slope.error);
}

std::string row(const MethodCurve& curve, const MethodCurve& beside) {
  std::string text = fmt::format("  {:<35}", curve.method.title);
  for (const Checked& point : curve.points) {
    text += fmt::format("{:>9}", percent(point.error.value));
  }
  const Factors against = factors(curve, beside);
  return text + fmt::format("  {} {:>8.3g} {:>8.3g}{}\n", slope_text(curve), against.time.value,
                            against.error.value, curve.heavy_tails ? "  heavy tails" : "");
}

const MethodCurve& beside_which(const std::vector<MethodCurve>& curves, const Options& options) {
  for (const MethodCurve& curve : curves) {
    if (curve.method.title == options.beside) return curve;
  }
  return fastest(curves);
}

constexpr int kSecondsColumn = 4;

// The key has a row below the curves for every three of them.
const char* const kErrorChart = R"gp(set terminal svg size 760,620 font "sans-serif,13"
set logscale xy
set format x "{}"
set xlabel "{}" offset 0,.5
set ylabel "error (root of relMSE)"
set key bmargin center horizontal maxcols 3 Left reverse samplen 1.5 font ",11" title " "
plot {}
)gp";

// A line and its band of one standard error for each of seven methods, with its name at its end.
// Colours that people with any kind of sight tell apart (Okabe and Ito 2008).
const char* const kSeven[] = {"#000000", "#d55e00", "#0072b2", "#009e73",
                              "#cc79a7", "#e69f00", "#56b4e9"};
const char* const kEfficiencyChart = R"gp(set terminal svg size 760,440 font "sans-serif,13"
set logscale xy
set format x "%g"
set xlabel "processor seconds"
set ylabel "efficiency beside lights, l = 1"
set key off
set rmargin 26
set style fill transparent solid 0.2 noborder
{}plot {}
)gp";

// The heights of the names beside the chart: those of the lines' ends, with room for a name between.
std::vector<double> label_heights(const std::vector<MethodCurve>& curves) {
  constexpr double kRow = 0.05;  // of the axis
  std::vector<std::pair<double, std::size_t>> ends;
  for (const MethodCurve* curve : seven_of(curves)) {
    const double end = efficiencies(*curve, curves[0]).back().value.value;
    ends.emplace_back(std::log10(end), ends.size());
  }
  std::ranges::sort(ends);
  const double row = kRow * std::max(1.0, std::ceil(ends.back().first) - std::floor(ends[0].first));
  std::vector<double> heights(ends.size());
  double below = -INFINITY;
  for (const auto& [end, i] : ends) {
    below = std::max(end, below + row);
    heights[i] = std::pow(10, below);
  }
  return heights;
}

void draw_efficiencies(const std::vector<MethodCurve>& curves, double pixels,
                       const std::filesystem::path& folder) {
  std::string csv = "method,seconds,efficiency,error_of_it\n", labels, plots;
  int i = 0;
  const std::vector<double> heights = label_heights(curves);
  for (const MethodCurve* curve : seven_of(curves)) {
    if (i > 0) csv += "\n\n";
    const std::vector<Efficiency> places = efficiencies(*curve, curves[0]);
    for (const Efficiency& at : places) {
      csv += fmt::format("\"{}\",{:.6g},{:.5g},{:.3g}\n", curve->method.title, at.seconds * pixels,
                         at.value.value, at.value.error);
    }
    labels +=
        fmt::format("set label \"{}\" at graph 1.02, first {:.5g} left tc rgb \"{}\" noenhanced\n",
                    curve->method.title, heights[i], kSeven[i]);
    plots += fmt::format(
        "{0}\"efficiency.csv\" index {1} using 2:($3-$4):($3+$4) skip {2} with filledcurves lc rgb "
        "\"{3}\", \"\" index {1} using 2:3 skip {2} with linespoints lc rgb \"{3}\" lw 2 pt 7 ps "
        ".4",
        plots.empty() ? "" : ", ", i, i == 0 ? 1 : 0, kSeven[i]);
    ++i;
  }
  pt::write_file(folder / "efficiency.csv", csv);
  draw(folder, "efficiency", fmt::format(fmt::runtime(kEfficiencyChart), labels, plots));
}

// Blue: light sampling; green: other chances of survival; red: hemisphere sampling; black: adaptive.
std::string plot(const std::vector<MethodCurve>& curves, int column) {
  std::string text;
  int used[3] = {0, 0, 0};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Method& method = curves[i].method;
    // Over samples, all engines have the same curve.
    if (method.engine && column != kSecondsColumn) continue;
    const Hue hue = method.way.direct == Direct::hemisphere                ? Hue::red
                    : method.way.survival != curves[0].method.way.survival ? Hue::green
                                                                           : Hue::blue;
    const char* const dark = method.adaptive ? "#000000" : "#8a9299";
    const std::string ink =
        method.adaptive || method.engine ? dark : color(hue, used[static_cast<int>(hue)]++);
    const bool by_tree = method.engine && *method.engine != pt::Engine::linear;
    text += fmt::format(
        "{}\"converge.csv\" index {} using {}:6:7 with yerrorlines lc rgb \"{}\" lw 1.5 pt 7 ps .4 "
        "dt {} title \"{}\"",
        text.empty() ? "" : ", ", i, column, ink, by_tree ? 2 : 1, method.title);
  }
  if (column == kSecondsColumn) {
    text +=
        ", \"front.csv\" using 1:2 skip 1 with lines lc rgb \"#000000\" lw 1.5 dt 3 title "
        "\"front\"";
  }
  return text;
}

void write_factors(const std::vector<MethodCurve>& curves, const std::filesystem::path& file) {
  std::string csv =
      "method,beside,time_for_the_same_error,error_of_it,error_at_the_same_time,error_of_it,"
      "rays_for_the_same_error,error_of_it\n";
  for (const MethodCurve& curve : curves) {
    for (const MethodCurve& other : curves) {
      const Factors f = factors(curve, other);
      csv += fmt::format("\"{}\",\"{}\",{:.5g},{:.3g},{:.5g},{:.3g},{:.5g},{:.3g}\n",
                         curve.method.title, other.method.title, f.time.value, f.time.error,
                         f.error.value, f.error.error, f.rays.value, f.rays.error);
    }
  }
  pt::write_file(file, csv);
}

// The last picture of each method: what its error is made of, and how even it is.
std::string parts_text(const std::vector<MethodCurve>& curves) {
  std::string text = fmt::format(
      "\nThe last picture of each method:\n  {:<35}{:>9}{:>9}{:>9}  {:>9}{:>9}{:>9}{:>10}\n", "",
      "samples", "error", "bias", "median", "99 %", "largest", "on black");
  for (const MethodCurve& curve : curves) {
    if (curve.method.engine) continue;
    const Checked& last = curve.points.back();
    const bool biased = last.bias2.value > kSignificant * last.bias2.error;
    text += fmt::format("  {:<35}{:>9.4g}{:>9}{:>9}  {:>9}{:>9}{:>9}{:>10}\n", curve.method.title,
                        last.samples, percent(last.error.value),
                        biased ? percent(std::sqrt(last.bias2.value)) : "-",
                        percent(last.pixel_errors.median), percent(last.pixel_errors.most),
                        percent(last.pixel_errors.largest), percent(last.black_samples));
  }
  return text +
         "Bias: the part of the error that is not noise, where it can be seen. Median, 99 %, "
         "largest: the noise\nof single pixels. On black: the samples in pixels that see no light "
         "at all.\n";
}

}  // namespace

std::string to_text(const std::vector<MethodCurve>& curves, const Options& options) {
  const MethodCurve& beside = beside_which(curves, options);
  std::string text = fmt::format(
      "{}, {} x {} pixels, at most {} bounces: the error; and time for the same error, error at "
      "the "
      "same time,\nboth beside {}\n\n  {:<35}",
      options.scene.string(), options.width, options.height, options.bounces, beside.method.title,
      "");
  for (const int samples : kSamples) text += fmt::format("{:>9}", fmt::format("s = {}", samples));
  text += fmt::format("  {:>14} {:>8} {:>8}\n", "slope", "time", "error");
  for (const MethodCurve& curve : curves) text += row(curve, beside);
  text += parts_text(curves);
  text += fmt::format(
      "\nAdaptive sampling: batches of {}, at most {} samples, tolerances {:g}, {:g}, {:g}, {:g} "
      "in place of s.\n"
      "The slope is that of log error over log samples: -0.5 where samples are independent.\n"
      "--beside METHOD compares with another one.\n",
      kBatch, kMaxAdaptive, kTolerances[0], kTolerances[1], kTolerances[2], kTolerances[3]);
  return text;
}

void write_curves(const std::vector<MethodCurve>& curves, const Options& options,
                  double cpu_seconds) {
  const std::filesystem::path& folder = options.out;
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
  write_factors(curves, folder / "factors.csv");
  csv = "seconds,error\n";
  for (const Checked& point : pareto_front(curves)) {
    csv += fmt::format("{:.6g},{:.6g}\n", point.seconds * pixels, point.error.value);
  }
  pt::write_file(folder / "front.csv", csv);
  draw_efficiencies(curves, pixels, folder);
  struct Axis {
    const char *file, *format, *label;
  };
  const Axis axes[] = {{"samples", "%g", "samples per pixel"},
                       {"seconds", "%g", "processor seconds"},
                       {"rays", "10^{%L}", "rays"}};
  for (int i = 0; i < 3; ++i) {
    draw(
        folder, axes[i].file,
        fmt::format(fmt::runtime(kErrorChart), axes[i].format, axes[i].label, plot(curves, 3 + i)));
  }
  pt::write_file(folder / "converge.json", to_json(curves, pixels, cpu_seconds).dump());
}

}  // namespace measure::scene
