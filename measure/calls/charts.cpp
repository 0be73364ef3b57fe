#include "measure/calls/print.h"
#include "measure/charts/gnuplot.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace measure::calls {

namespace {

const char* const kChart = R"gp($points << END
{}END
set logscale xy
set title "{}" noenhanced
set xlabel "{}"
set ylabel "{}"
set xrange [{:.6g}:{:.6g}]
set yrange [{:.6g}:{:.6g}]
{}
set key below Left reverse samplen 2
plot {}
)gp";

// A candidate: one point, or one point per table.
struct ChartLine {
  std::string name, title;
  std::optional<std::size_t> own;  // the number among a user's own codes
  std::vector<std::array<double, 2>> points;
};

std::string meaning(const About& about) {
  if (about.kind == Kind::estimator) return "noise: standard deviation of a call, over its mean";
  return about.kind == Kind::tree ? "boxes and triangles tested per ray"
                                  : "largest " + about.errors[0];
}

// Zero has no place on a logarithmic axis.
double charted(const About& about, const Row& row) {
  return std::max(accuracy(about, row).value, about.kind == Kind::exact ? 1e-17 : 1e-6);
}

// A folder may have any name, but gnuplot reads some signs as commands.
std::string title_of(const std::string& name) {
  std::string title;
  for (const char c : name) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
    title += is_plain ? c : ' ';
  }
  return title;
}

// A candidate without a finite error is only in the table.
std::vector<ChartLine> curves(const About& about, const std::vector<Table>& tables) {
  std::vector<ChartLine> all;
  std::size_t own = 0;
  for (std::size_t i = 0; i < tables[0].rows.size(); ++i) {
    const Row& first = tables[0].rows[i];
    const std::optional<std::size_t> number =
        first.is_own ? std::optional(own++) : std::optional<std::size_t>();
    if (!first.problem.empty()) continue;
    ChartLine curve{first.name, title_of(first.name), number, {}};
    bool is_wrong = false, is_finite = true;
    for (const Table& table : tables) {
      const Row& row = table.rows[i];
      curve.points.push_back({row.nanoseconds.value, charted(about, row)});
      is_wrong = is_wrong || !mistake(about, row).empty();
      is_finite = is_finite && std::isfinite(curve.points.back()[1]);
    }
    if (is_wrong) curve.title += " (wrong)";
    if (is_finite) all.push_back(curve);
  }
  return all;
}

// The steps of the front, from the fastest on, without points that are not below the last.
std::vector<std::array<double, 2>> front_points(const About& about,
                                                const std::vector<Table>& tables) {
  const auto fronts = pareto_fronts(about, tables);
  std::vector<std::array<double, 2>> points, steps;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    for (std::size_t k = 0; k < tables[i].rows.size(); ++k) {
      const Row& row = tables[i].rows[k];
      if (fronts[i][k]) points.push_back({row.nanoseconds.value, charted(about, row)});
    }
  }
  std::sort(points.begin(), points.end());
  for (const auto& point : points) {
    if (steps.empty() || point[1] < steps.back()[1]) steps.push_back(point);
  }
  return steps;
}

std::string block(const std::vector<std::array<double, 2>>& points, double unit) {
  std::string text;
  for (const auto& [time, off] : points) text += fmt::format("{:.6g},{:.6g}\n", time / unit, off);
  return text + "\n\n";
}

struct Span {
  double low = std::numeric_limits<double>::infinity(), high = 0;

  void grow(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  // The span with some room at both ends.
  Span roomy(double most) const {
    const double factor = std::clamp(high / low, 1.3, most);
    return {low / std::pow(factor, 0.12), high * std::pow(factor, 0.12)};
  }
};

// About five steps of 1, 2 or 5 times a power of ten.
double even_step(double length) {
  const double step = length / 5, power = std::pow(10, std::floor(std::log10(step)));
  return power * (step < 2 * power ? 1 : step < 5 * power ? 2 : 5);
}

// Numbers for an axis: at even distances if it is short, else numbers with few digits.
std::vector<double> ticks(const Span& span) {
  constexpr double kShort = 3, kMiddle = 30;
  std::vector<double> all;
  if (span.high < kShort * span.low) {
    const double step = even_step(span.high - span.low);
    for (double i = std::ceil(span.low / step); i * step <= span.high; ++i) all.push_back(i * step);
    return all;
  }
  const bool many = span.high < kMiddle * span.low;
  const std::vector<double> digits =
      many ? std::vector<double>{1, 2, 3, 5, 7} : std::vector<double>{1, 3};
  const int least = static_cast<int>(std::floor(std::log10(span.low)));
  for (int exponent = least; std::pow(10, exponent) < span.high; ++exponent) {
    for (const double digit : digits) all.push_back(digit * std::pow(10, exponent));
  }
  std::erase_if(all, [&](double at) { return at < span.low || at > span.high; });
  return all;
}

// The reference and a user's codes are large.
std::string style(const ChartLine& curve, std::size_t number, bool lines,
                  const std::string& color) {
  const char* const how = lines ? "linespoints" : "points";
  if (curve.own) {
    const OwnInk own = own_ink(*curve.own);
    return fmt::format("with {} lc rgb \"{}\" lw 2 pt {} ps 1.4", how, own.color, own.mark);
  }
  if (number == 0) return fmt::format("with {} lc rgb \"{}\" lw 2 pt 7 ps 1.4", how, ink::kBlack);
  static const int kPoints[] = {4, 6, 8, 10, 12, 1, 2, 3};
  return fmt::format("with {} lc rgb \"{}\" lw 1.5 pt {} ps 1", how, color, kPoints[number % 8]);
}

void draw_one(const About& about, const std::vector<Table>& tables,
              const std::filesystem::path& folder, const std::string& name) {
  const std::vector<ChartLine> all = curves(about, tables);
  const auto front = front_points(about, tables);
  const Unit unit = unit_of(tables[0].rows[0].nanoseconds.value);
  Span times, offs;
  std::string data, plot;
  std::vector<std::string> inks{ink::kBlack};
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const auto& [time, off] : all[i].points) {
      times.grow(time / unit.nanoseconds);
      offs.grow(off);
    }
    data += block(all[i].points, unit.nanoseconds);
    if (i > 0) inks.push_back(ink_of(all[i].name, inks));
    plot += fmt::format("$points index {} using 1:2 {} title \"{}\"", i,
                        style(all[i], i, tables.size() > 1, inks[i]), all[i].title);
    plot += under_the_pointer(
                {fmt::format("$points index {}", i), all[i].title, "$1", "$2", "$2", ""}) +
            ", ";
  }
  data += block(front, unit.nanoseconds);
  plot += fmt::format(
      "$points index {} using 1:2 with steps lc rgb \"#8a9299\" lw 1.5 dt 2 title \"front\"",
      all.size());
  const Span x = times.roomy(100), y = offs.roomy(1e4);
  // Errors differ so much that powers of ten are enough.
  const std::string y_ticks = about.kind == Kind::exact
                                  ? "set format y \"10^{%L}\""
                                  : fmt::format("set ytics ({:g})", fmt::join(ticks(y), ","));
  const std::string x_ticks = fmt::format("set xtics ({:g})", fmt::join(ticks(x), ","));
  const std::string machine = processor();
  const std::string title =
      about.slug + (tables.size() > 1 || tables[0].name.empty() ? "" : ", " + tables[0].name);
  draw(folder, name,
       fmt::format(fmt::runtime(kChart), data, title + (machine.empty() ? "" : "\\n" + machine),
                   fmt::format("{} of processor time per call", unit.name), meaning(about), x.low,
                   x.high, y.low, y.high, x_ticks + '\n' + y_ticks, plot),
       fmt::format("{}: {} beside the processor time of a call on {}. {}", title, meaning(about),
                   machine.empty() ? "one processor" : machine, about.inputs));
}

}  // namespace

void draw_charts(const Results& results, const std::filesystem::path& folder) {
  const About& about = *results.about;
  if (about.one_front) return draw_one(about, results.tables, folder, about.slug);
  for (const Table& table : results.tables) {
    std::string name = about.slug;
    if (results.tables.size() > 1) name += "_" + table.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    draw_one(about, {table}, folder, name);
  }
}

}  // namespace measure::calls
