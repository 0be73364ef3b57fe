#include "writeup/stability/print.h"

#include "grader/report/csv.h"
#include "pt/file.h"
#include "writeup/gnuplot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace writeup::stability {

namespace {

constexpr int kColumn = 12;

// "1.2e-07", "0", "none" without a number; with a mark where some cases had none.
std::string cell(const Point& point) {
  if (std::isnan(point.error)) return "none";
  const std::string number = point.error == 0 ? "0" : fmt::format("{:.2g}", point.error);
  return point.without > 0 ? number + " *" : number;
}

// Whether the line belongs to what the chart is about.
bool is_column(const Charts& charts, const Chart& chart, std::size_t line) {
  const Line::Kind kind = charts.lines[line].kind;
  return kind == Line::Kind::reference || kind == Line::Kind::submission ||
         std::ranges::count(chart.methods, line) > 0;
}

// The first reason of the lines of the table, for example of a crash.
std::string why_none(const Charts& charts, const Chart& chart) {
  std::string text;
  for (std::size_t i = 0; i < charts.lines.size(); ++i) {
    if (!is_column(charts, chart, i)) continue;
    const auto at =
        std::ranges::find_if(chart.points[i], [](const Point& p) { return p.without > 0; });
    if (at == chart.points[i].end()) continue;
    text += fmt::format("  * {}: {} in {} of {} cases at {:.3g}\n", charts.lines[i].title,
                        at->reason, at->without, at->cases, at->place);
  }
  return text;
}

std::string table(const Charts& charts, const Chart& chart) {
  std::string text =
      fmt::format("{}: {}\n  {}\n  by {}\n", chart.slug, chart.title, chart.error, chart.input);
  if (chart.promised_last > 0) {
    text += fmt::format("  promised: at most {:g} from {:g} to {:g}\n", chart.limit,
                        chart.promised_first, chart.promised_last);
  }
  std::string head = fmt::format("{:>10}", "");
  char letter = 'a';
  for (std::size_t i = 0; i < charts.lines.size(); ++i) {
    if (!is_column(charts, chart, i)) continue;
    text += fmt::format("  {}: {}\n", letter, charts.lines[i].title);
    head += fmt::format("{:>{}}", letter++, kColumn);
  }
  text += head + "\n";
  for (std::size_t place = 0; place < chart.points[0].size(); ++place) {
    text += fmt::format("{:>10.3g}", chart.points[0][place].place);
    for (std::size_t i = 0; i < charts.lines.size(); ++i) {
      if (!is_column(charts, chart, i)) continue;
      const bool known = place < chart.points[i].size();
      text += fmt::format("{:>{}}", known ? cell(chart.points[i][place]) : "", kColumn);
    }
    text += "\n";
  }
  return text + why_none(charts, chart) + "  source: " + chart.source + "\n";
}

// What a logarithmic axis can show.
struct Range {
  double bottom = 1e-17, top = 1;
};

Range range_of(const Chart& chart) {
  double least = 1e300, most = 0;
  for (const auto& points : chart.points) {
    for (const Point& point : points) {
      if (!(point.error > 0)) continue;
      least = std::min(least, point.error);
      most = std::max(most, point.error);
    }
  }
  if (chart.limit > 0) least = std::min(least, chart.limit);
  return most == 0 ? Range{} : Range{least / 3, std::max(most, chart.limit) * 3};
}

std::string data(const Charts& charts, const Chart& chart) {
  std::string csv = "line,place,error,cases,without,reason\n";
  for (std::size_t i = 0; i < charts.lines.size(); ++i) {
    if (i > 0) csv += "\n\n";
    // gnuplot counts blocks that have lines.
    if (chart.points[i].empty())
      csv += grader::report::csv_field(charts.lines[i].title) + ",,,,,\n";
    for (const Point& p : chart.points[i]) {
      csv += fmt::format("{},{:g},{},{},{},{}\n", grader::report::csv_field(charts.lines[i].title),
                         p.place, std::isnan(p.error) ? "" : fmt::format("{:.4g}", p.error),
                         p.cases, p.without, grader::report::csv_field(p.reason));
    }
  }
  return csv;
}

struct Pen {
  std::string color;
  double width;
  bool named;
};

Pen pen_of(const Charts& charts, const Chart& chart, std::size_t line) {
  constexpr Hue kHues[] = {Hue::red, Hue::blue, Hue::green};
  if (!is_column(charts, chart, line)) return {"#c8ccd0", 1, false};
  if (charts.lines[line].kind == Line::Kind::reference) return {"#000000", 3, true};
  if (charts.lines[line].kind == Line::Kind::submission) return {"#e08214", 3, true};
  const auto method = std::ranges::find(chart.methods, line) - chart.methods.begin();
  return {color(kHues[method % 3], static_cast<int>(1 + 2 * (method / 3))), 1.5, true};
}

void draw_chart(const Charts& charts, const Chart& chart, const std::filesystem::path& folder) {
  const std::string name = chart.slug + "." + chart.name;
  pt::write_file(folder / (name + ".csv"), data(charts, chart));
  const Range range = range_of(chart);
  const auto& places = chart.points[0];
  std::string commands = fmt::format(
      "set logscale xy\nset format \"%h\"\nset xrange [{:g}:{:g}]\nset yrange [{:g}:{:g}]\n"
      "set xlabel \"{}\"\nset ylabel \"{}\"\nset title \"{}\"\nset key outside below left "
      "vertical maxrows 3\n",
      places.front().place, places.back().place, range.bottom, range.top, chart.input, chart.error,
      chart.title);
  std::string plot = "plot ";
  if (chart.promised_last > 0) {
    // The corner that the contract allows.
    commands += fmt::format(
        "set object rectangle from {:g},{:g} to {:g},{:g} fc rgb \"#d9f0d3\" fs solid noborder "
        "behind\n",
        chart.promised_first, range.bottom, chart.promised_last,
        std::max(chart.limit, range.bottom * 1.5));
  }
  // The thin ones first, so that the others lie above them.
  for (const bool named : {false, true}) {
    for (std::size_t i = 0; i < charts.lines.size(); ++i) {
      const Pen pen = pen_of(charts, chart, i);
      if (pen.named != named) continue;
      plot += fmt::format(
          "\"{0}.csv\" index {1} using 2:($3 > {2:g} ? $3 : {2:g}) skip {3} with lines lc rgb "
          "\"{4}\" lw {5} {6}, \"\" index {1} using 2:($5 > 0 ? {7:g} : NaN) skip {3} with points "
          "pt "
          "2 ps .8 lc rgb \"{4}\" notitle, ",
          name, i, range.bottom, i == 0 ? 1 : 0, pen.color, pen.width,
          pen.named ? "title \"" + charts.lines[i].title + "\"" : "notitle", range.top / 1.5);
    }
  }
  draw(folder, name, commands + plot.substr(0, plot.size() - 2) + "\n");
}

}  // namespace

std::string to_text(const Charts& charts) {
  std::string text;
  for (const Chart& chart : charts.charts) text += table(charts, chart) + "\n";
  for (const Line& line : charts.lines) {
    if (!line.unusable.empty()) text += line.title + " is not measured: " + line.unusable + "\n";
  }
  return text;
}

void write_charts(const Charts& charts, const std::filesystem::path& folder) {
  for (const Chart& chart : charts.charts) draw_chart(charts, chart, folder);
}

}  // namespace writeup::stability
