#include "measure/charts/gnuplot.h"
#include "measure/scene/converge.h"
#include "measure/scene/json.h"
#include "measure/scene/print.h"
#include "pt/file.h"

#include <algorithm>

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
