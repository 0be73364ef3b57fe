#include "grader/report/csv.h"
#include "measure/charts/gnuplot.h"
#include "measure/failure/print.h"
#include "pt/file.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

namespace measure::failure {

namespace {

// The range of a logarithmic axis. If some errors are 0, the lowest tic means 0.
struct Range {
  double bottom = 1e-17, zero = 3e-17, top = 1;
  bool has_zeros = true;
};

// A quoted text for gnuplot.
std::string quoted(std::string text) {
  std::ranges::replace(text, '"', '\'');
  return '"' + text + '"';
}

// The noise of the reference at a place, where the error is a mean of random numbers.
double noise_at(const Chart& chart, double place) {
  constexpr double kRounding = 1e-9;
  for (const Point& point : chart.points[0]) {
    if (std::abs(place / point.place - 1) < kRounding) return point.noise;
  }
  return 0;
}

Range range_of(const Charts& charts, const Chart& chart) {
  double least = 1e300, most = 0;
  bool has_zeros = false;
  for (std::size_t i = 0; i < charts.lines.size(); ++i) {
    if (!is_shown(charts, chart, i)) continue;
    for (const Point& point : chart.points[i]) {
      has_zeros = has_zeros || point.error == 0;
      if (!(point.error > 0)) continue;  // NaN too
      least = std::min(least, point.error);
      most = std::max(most, point.error);
    }
  }
  const auto grow = [&](double error) {
    if (!(error > 0)) return;
    least = std::min(least, error);
    most = std::max(most, error);
  };
  std::ranges::for_each(chart.theory, grow);
  if (most == 0) return {};
  // The edge of a promise is shown near lines; a limit far above all lines fills the column.
  const double above = 100 * most;
  for (const Promised& promised : chart.promised) {
    for (const auto& [place, limit] : promised.corners) {
      grow(std::min(limit + kErrors * noise_at(chart, place), above));
    }
  }
  // The value at a part of the axis's height.
  const double part = std::pow(3 * most / least, 0.08);
  return {least / part / part / 1.5, least / part / 1.5, most * part * 1.5, has_zeros};
}

std::string data(const Charts& charts, const Chart& chart) {
  std::string csv = "line,place,error,cases,without,reason,noise\n";
  for (std::size_t i = 0; i < charts.lines.size(); ++i) {
    if (i > 0) csv += "\n\n";
    // gnuplot does not count empty blocks: a line of the chart without points gets a row without values.
    if (chart.points[i].empty())
      csv += grader::report::csv_field(charts.lines[i].title) + ",,,,,,\n";
    for (const Point& p : chart.points[i]) {
      csv += fmt::format("{},{:g},{},{},{},{},{:.2g}\n",
                         grader::report::csv_field(charts.lines[i].title), p.place,
                         std::isnan(p.error) ? "" : fmt::format("{:.4g}", p.error), p.cases,
                         p.without, grader::report::csv_field(p.reason), p.noise);
    }
  }
  return csv;
}

// A block behind all lines.
std::string theory_data(const Chart& chart) {
  std::string csv = "\n\n";
  for (std::size_t i = 0; i < chart.theory.size(); ++i) {
    csv += fmt::format("theory,{:g},{:.4g},,,,\n", chart.points[0][i].place, chart.theory[i]);
  }
  return csv;
}

constexpr const char* kOthers = "#c8ccd0";  // the ink of lines without a name

// Returns whether there is a line without a name.
bool has_others(const Charts& charts, const Chart& chart) {
  for (std::size_t i = 0; i < charts.lines.size(); ++i) {
    if (is_shown(charts, chart, i) && !is_named(charts, chart, i) && !chart.points[i].empty())
      return true;
  }
  return false;
}

struct Pen {
  std::string color;
  double width;
  int dashes;  // gnuplot's dash type: 1 is a solid line
  bool named;
};

// A text in lines of at most `width` letters, with `between` two of them.
std::string wrapped(const std::string& text, std::size_t width,
                    const std::string& between = "\\n") {
  std::string lines;
  std::size_t column = 0;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool fits = column + 1 + word.size() <= width;
    if (column > 0) lines += fits ? " " : between;
    lines += word;
    column = (column > 0 && fits ? column + 1 : 0) + word.size();
  }
  return lines;
}

// A colour for each line, other than those of the methods beside it in any chart.
std::vector<std::string> inks_of(const Charts& charts) {
  std::vector<std::string> inks(charts.lines.size());
  for (std::size_t line = 0; line < inks.size(); ++line) {
    std::vector<std::string> taken;
    for (const Chart& chart : charts.charts) {
      if (std::ranges::count(chart.methods, line) == 0) continue;
      for (const std::size_t other : chart.methods) taken.push_back(inks[other]);
    }
    inks[line] = ink_of(id_of(charts.lines[line]), taken);
  }
  return inks;
}

// Each method has its own dashes, so that lines on top of each other can be distinguished.
Pen pen_of(const Charts& charts, const Chart& chart, std::size_t line, const std::string& color) {
  if (!is_named(charts, chart, line)) return {kOthers, 1, 1, false};
  if (charts.lines[line].kind == CurveLine::Kind::reference) return {ink::kBlack, 3, 1, true};
  if (charts.lines[line].kind == CurveLine::Kind::submission) return {ink::kOrange, 3, 1, true};
  const auto method = std::ranges::find(chart.methods, line) - chart.methods.begin();
  return {color, 2, 2 + static_cast<int>(method), true};
}

const char* color_of(const Promised& promised) { return promised.bonus ? "#fde8c8" : "#d9f0d3"; }

// A filled area down to the axis: all errors that the contract allows, with as many standard errors
// as a right mean may be off by chance. A limit of 0 reaches to the tic 0, and a promise for a single
// place gets some width.
std::string area_of(const Chart& chart, const Promised& promised, const Range& range) {
  constexpr double kHalfWidth = 1.12;
  const double zero = std::sqrt(range.zero * range.zero * range.zero / range.bottom);
  auto corners = promised.corners;
  for (auto& [place, limit] : corners) limit += kErrors * noise_at(chart, place);
  if (corners.size() == 2 && corners[0].place == corners[1].place) {
    corners[0].place /= kHalfWidth;
    corners[1].place *= kHalfWidth;
  }
  std::string area =
      fmt::format("set object polygon from {:g},{:g}", corners.front().place, range.bottom);
  for (const auto& [place, limit] : corners) {
    area += fmt::format(" to {:g},{:g}", place, std::clamp(limit, zero, range.top));
  }
  area += fmt::format(" to {:g},{:g} to {:g},{:g}", corners.back().place, range.bottom,
                      corners.front().place, range.bottom);
  return area + fmt::format(" fc rgb \"{}\" fs solid noborder clip behind\n", color_of(promised));
}

// Numbers at powers of ten above the tic 0, at most about eight: below it, a number would be no error.
std::string tics_above_zero(const Range& range) {
  constexpr double kMostTics = 8;
  const double first = std::ceil(std::log10(2 * range.zero)), last = std::log10(range.top);
  const double step = std::max(1.0, std::ceil((last - first) / kMostTics));
  return fmt::format("set ytics 1e{:g},1e{:g},1e{:g}\nset ytics add (\"0\" {:g})\n", first, step,
                     std::ceil(last), range.zero);
}

std::string axes(const Chart& chart, const Range& range, std::size_t keys) {
  const auto& places = chart.points[0];
  constexpr std::size_t kLetters = 68, kSmallLetters = 84;
  const std::string input = wrapped(chart.input, kLetters),
                    source = wrapped(chart.source, kSmallLetters, "}\\n{/*0.8 "),
                    error = wrapped(error_text(chart), kLetters);
  const std::size_t rows = keys + std::ranges::count(input + source, '\\');
  std::string commands = fmt::format(
      "set logscale xy\nset format \"10^{{%L}}\"\nset xrange [{:g}:{:g}]\nset yrange [{:g}:{:g}]\n"
      "set xlabel {}\nset title \"{{/:Bold {}}}\\n{}\"\n"
      "set terminal svg size 520,{} font \"sans-serif,13\"\nset bmargin {}\nset rmargin 3\n"
      "set key at screen 0.06,screen 0.01 left bottom vertical Left reverse maxrows {} samplen 3 "
      "width -2\n",
      places.front().place, places.back().place, range.bottom, range.top,
      quoted(input + "\\n{/*0.8 " + source + "}"), chart.title, error, 420 + 20 * rows,
      5.0 + static_cast<double>(rows), keys);
  if (range.has_zeros) commands += tics_above_zero(range);
  // A short axis needs every number that it has.
  const auto is_short = [](double low, double high) {
    return std::abs(std::log10(high / low)) < 3;
  };
  if (is_short(places.front().place, places.back().place)) commands += "set format x \"%g\"\n";
  if (is_short(range.zero, range.top)) commands += "set format y \"%g\"\n";
  for (const bool bonus : {true, false}) {
    for (const Promised& promised : chart.promised) {
      if (promised.bonus == bonus) commands += area_of(chart, promised, range);
    }
  }
  return commands;
}

bool has_noise(const std::vector<Point>& points) {
  return std::ranges::any_of(points, [](const Point& point) { return point.noise > 0; });
}

void draw_chart(const Charts& charts, const Chart& chart, const std::vector<std::string>& inks,
                const std::filesystem::path& folder) {
  const std::string name = chart.slug + "." + chart.name;
  pt::write_file(folder / (name + ".csv"),
                 data(charts, chart) + (chart.theory.empty() ? "" : theory_data(chart)));
  const Range range = range_of(charts, chart);
  std::string plot = "plot ";
  std::size_t keys = 0;
  // Thin lines come first, so that others are drawn over them; marks for missing numbers come last.
  for (const bool named : {false, true}) {
    for (std::size_t i = 0; i < charts.lines.size(); ++i) {
      const Pen pen = pen_of(charts, chart, i, inks[i]);
      if (pen.named != named || !is_shown(charts, chart, i)) continue;
      keys += named ? 1 : 0;
      plot += fmt::format(
          "\"{0}.csv\" index {1} using 2:($3 > {2:g} ? $3 : {2:g}) skip {3} with lines lc rgb "
          "\"{4}\" lw {5} dt {6} {7}, \"\" index {1} using 2:($5 > 0 ? {8:g} : NaN) skip {3} with "
          "points pt 2 ps .8 lc rgb \"{4}\" notitle, ",
          name, i, range.zero, i == 0 ? 1 : 0, pen.color, pen.width, pen.dashes,
          pen.named ? "title " + quoted(charts.lines[i].title) + " noenhanced" : "notitle",
          range.top / 1.3);
      if (named) {
        const Values values{fmt::format("\"{}.csv\" index {} skip {}", name, i, i == 0 ? 1 : 0),
                            charts.lines[i].title,
                            "$2",
                            fmt::format("($3 > {0:g} ? $3 : {0:g})", range.zero),
                            "$3",
                            has_noise(chart.points[i]) ? "$7" : ""};
        plot.resize(plot.size() - 2);
        plot += under_the_pointer(values) + ", ";
      }
      if (named && has_noise(chart.points[i])) {
        plot += fmt::format(
            "\"{0}.csv\" index {1} using 2:3:($3 > $7 + {2:g} ? $3 - $7 : {2:g}):($3 + $7) skip "
            "{3} "
            "with yerrorbars pt 7 ps .3 lc rgb \"{4}\" notitle, ",
            name, i, range.bottom, i == 0 ? 1 : 0, pen.color);
      }
    }
  }
  if (!chart.theory.empty()) {
    ++keys;
    plot += fmt::format(
        "\"{}.csv\" index {} using 2:($3 > {:g} ? $3 : NaN) with points pt 6 ps .7 lc rgb "
        "\"#6a3d9a\" title \"theory\"",
        name, charts.lines.size(), range.bottom);
    plot +=
        under_the_pointer({fmt::format("\"{}.csv\" index {}", name, charts.lines.size()), "theory",
                           "$2", fmt::format("($3 > {:g} ? $3 : NaN)", range.bottom), "$3", ""}) +
        ", ";
  }
  if (has_others(charts, chart)) {
    ++keys;
    plot +=
        fmt::format("NaN with lines lc rgb \"{}\" lw 1 title \"other right solutions\", ", kOthers);
  }
  // The areas have entries in the key too.
  for (const Promised& promised : chart.promised) {
    ++keys;
    plot += fmt::format("NaN with boxes fs solid lc rgb \"{}\" title \"{}\", ", color_of(promised),
                        promised.bonus ? "promised by a bonus" : "promised by the contract");
  }
  draw(folder, name, axes(chart, range, keys) + plot.substr(0, plot.size() - 2) + "\n",
       fmt::format("{}: {}, by {}. {}", chart.title, error_text(chart), chart.input, chart.source));
}

}  // namespace

void write_charts(const Charts& charts, const std::filesystem::path& folder) {
  const std::vector<std::string> inks = inks_of(charts);
  for (const Chart& chart : charts.charts) draw_chart(charts, chart, inks, folder);
}

}  // namespace measure::failure
