#include "measure/charts/gnuplot.h"
#include "measure/charts/numbers.h"
#include "measure/scene/converge.h"
#include "measure/scene/print.h"
#include "pt/file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace measure::scene {

namespace {

// A short name for a chart: "lights, l = 1, adaptive" differs from the first method by one word.
std::string name_of(const MethodCurve& curve, const MethodCurve& first) {
  const std::string common = first.method.title + ", ";
  std::string name = curve.method.title;
  if (name.starts_with(common)) name.erase(0, common.size());
  return name + (curve.fails ? ": fails" : "");
}

// The points of a method that fails are crosses.
const char* mark_of(const MethodCurve& curve) { return curve.fails ? "2 ps 1" : "7 ps .4"; }

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
  if (curve.fails) {
    const double off =
        seen_bias(curve.points.back().bias2).value_or(curve.points.back().error.value);
    return text + fmt::format("  fails: off by {} with any number of samples\n", percent(off));
  }
  const Factors against = factors(curve, beside);
  const auto with_error = [](const Uncertain& factor) {
    return fmt::format("{:.3g} \u00b1 {:.2g}", factor.value, factor.error);
  };
  return text + fmt::format("  {} {:>13} {:>13}{}\n", slope_text(curve), with_error(against.time),
                            with_error(against.error), curve.heavy_tails ? "  heavy tails" : "");
}

const MethodCurve& beside_which(const std::vector<MethodCurve>& curves, const Options& options) {
  for (const MethodCurve& curve : curves) {
    if (curve.method.title == options.beside && !curve.fails) return curve;
  }
  return fastest(curves);
}

// All charts show the same methods in the same colours, with their names at the ends of the lines.
const char* const kStyle = R"gp(set logscale xy
set format x "{}"
set format y "%g"
set xlabel "{}"
set ylabel "{}"
set style fill transparent solid 0.2 noborder
{}plot {}
)gp";

std::string settings_of(const Options& options) {
  return fmt::format("at most {} bounces; l = 1, survival .7 if nothing else is said",
                     options.bounces);
}

// The lowest and the highest number of a chart, with some room beside them.
struct Span {
  double low = INFINITY, high = 0;

  void grow(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  std::string names(std::vector<NamedEnd> ends) const {
    return names_beside(std::move(ends), low / 1.3, high * 1.3);
  }
};

// A line and its band of one standard error for each method. A method below this efficiency has its number
// beside its name instead: its line would take most of the height from all others.
constexpr double kLowestDrawn = 0.05;

void draw_efficiencies(const std::vector<DrawnMethod>& drawn, const MethodCurve& first,
                       double pixels, const Options& options) {
  const std::string name = options.prefix + "efficiency";
  std::string csv = "method,seconds,efficiency,error_of_it\n", plots;
  std::vector<NamedEnd> ends;
  Span span;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const MethodCurve& curve = *drawn[i].curve;
    if (i > 0) csv += "\n\n";
    const std::vector<Efficiency> places = efficiencies(curve, first);
    for (const Efficiency& at : places) {
      csv += fmt::format("\"{}\",{:.6g},{:.5g},{:.3g}\n", curve.method.title, at.seconds * pixels,
                         at.value.value, at.value.error);
      if (at.value.value > kLowestDrawn) span.grow(at.value.value);
    }
    const double last = places.back().value.value;
    const std::string below = last > kLowestDrawn ? "" : fmt::format(": {:.2g}", last);
    ends.push_back({name_of(curve, first) + below, drawn[i].color, last});
    plots += fmt::format(
        "{0}\"{5}.csv\" index {1} using 2:($3-$4):($3+$4) skip {2} with filledcurves lc rgb "
        "\"{3}\", \"\" index {1} using 2:3 skip {2} with linespoints lc rgb \"{3}\" lw 2 pt {4}",
        i > 0 ? ", " : "", i, i == 0 ? 1 : 0, drawn[i].color, mark_of(curve), name);
    plots += under_the_pointer({fmt::format("\"{}.csv\" index {} skip {}", name, i, i == 0 ? 1 : 0),
                                name_of(curve, first), "$2", "$3", "$3", "$4"});
  }
  pt::write_file(options.out / (name + ".csv"), csv);
  draw(options.out, name,
       title_of(options, settings_of(options)) +
           fmt::format(fmt::runtime(kStyle), "%g", processor_seconds(),
                       "efficiency beside lights, l = 1", span.names(std::move(ends)), plots),
       caption_of(options, "Efficiency, 1 / (time x error^2), beside light sampling with l = 1",
                  settings_of(options), processor()));
}

// The error over a column of converge.csv. Over samples and rays all engines have the same line.
struct Axis {
  const char *file, *format, *label;
  int column;
};
constexpr Axis kAxes[] = {{"samples", "%g", "samples per pixel", 3},
                          {"seconds", "%g", "", 4},
                          {"rays", "10^{%L}", "rays", 5}};

void draw_errors(const std::vector<DrawnMethod>& drawn, const MethodCurve& first, const Axis& axis,
                 const Options& options) {
  const bool over_seconds = axis.column == 4;
  std::string plots;
  std::vector<NamedEnd> ends;
  Span span;
  for (const DrawnMethod& each : drawn) {
    if (each.curve->method.engine && !over_seconds) continue;
    for (const Checked& point : each.curve->points) span.grow(point.error.value);
    ends.push_back(
        {name_of(*each.curve, first), each.color, each.curve->points.back().error.value});
    plots += fmt::format(
        "{}\"{}converge.csv\" index {} using {}:6:7 with yerrorlines lc rgb \"{}\" lw 2 pt {}",
        plots.empty() ? "" : ", ", options.prefix, each.curve - &first, axis.column, each.color,
        mark_of(*each.curve));
    plots += under_the_pointer(
        {fmt::format("\"{}converge.csv\" index {}", options.prefix, each.curve - &first),
         name_of(*each.curve, first), fmt::format("${}", axis.column), "$6", "$6", "$7"});
  }
  if (over_seconds) {
    plots += fmt::format(", \"{}front.csv\" using 1:2 skip 1 with lines lc rgb \"{}\" lw 1.5 dt 3",
                         options.prefix, ink::kBlack);
  }
  const std::string label = over_seconds ? processor_seconds() : axis.label;
  draw(options.out, options.prefix + axis.file,
       title_of(options, settings_of(options)) + fmt::format(fmt::runtime(kStyle), axis.format,
                                                             label, "error (root of relMSE)",
                                                             span.names(std::move(ends)), plots),
       caption_of(options,
                  fmt::format("Error over {}", over_seconds ? "processor seconds" : axis.label),
                  settings_of(options), over_seconds ? processor() : ""));
}

void write_factors(const std::vector<MethodCurve>& curves, const std::filesystem::path& file) {
  std::string csv =
      "method,beside,time_for_the_same_error,error_of_it,error_at_the_same_time,error_of_it,"
      "rays_for_the_same_error,error_of_it\n";
  for (const MethodCurve& curve : curves) {
    for (const MethodCurve& other : curves) {
      if (curve.fails || other.fails) continue;
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
    const std::optional<double> bias = seen_bias(last.bias2);
    text += fmt::format("  {:<35}{:>9.4g}{:>9}{:>9}  {:>9}{:>9}{:>9}{:>10}\n", curve.method.title,
                        last.samples, percent(last.error.value), bias ? percent(*bias) : "-",
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
      "{}, at most {} bounces: the error; and time for the same error, error at the same time,\n"
      "both beside {}\n\n  {:<35}",
      subject_of(options), options.bounces, beside.method.title, "");
  for (const int samples : kSamples) text += fmt::format("{:>9}", fmt::format("s = {}", samples));
  text += fmt::format("  {:>14} {:>13} {:>13}\n", "slope", "time", "error");
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
  const auto file = [&](const char* name) { return options.out / (options.prefix + name); };
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
  pt::write_file(file("converge.csv"), csv);
  write_factors(curves, file("factors.csv"));
  csv = "seconds,error\n";
  for (const FrontPlace& place : front_of(curves)) {
    csv += fmt::format("{:.6g},{:.6g}\n", place.seconds * pixels, place.error);
  }
  pt::write_file(file("front.csv"), csv);
  const std::vector<DrawnMethod> drawn = seven_of(curves);
  draw_efficiencies(drawn, curves[0], pixels, options);
  for (const Axis& axis : kAxes) draw_errors(drawn, curves[0], axis, options);
  pt::write_file(file("converge.json"), to_json(curves, pixels, cpu_seconds).dump());
}

}  // namespace measure::scene
