#include "measure/failure/print.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace measure::failure {

std::string error_text(const Chart& chart) {
  return chart.drawn.empty() ? chart.error : chart.error + ", " + chart.drawn;
}

namespace {

constexpr int kColumn = 12;

// "1.2e-07", "0", or "none" without a number; with a mark if some cases had no number.
std::string cell(const Point& point) {
  if (std::isnan(point.error)) return "none";
  const std::string number = point.error == 0 ? "0" : fmt::format("{:.2g}", point.error);
  return point.without > 0 ? number + " *" : number;
}

// The first reason among the table's lines, for example for a crash.
std::string why_none(const Charts& charts, const Chart& chart) {
  std::string text;
  for (std::size_t i = 0; i < charts.lines.size(); ++i) {
    if (!is_named(charts, chart, i)) continue;
    const auto at =
        std::ranges::find_if(chart.points[i], [](const Point& p) { return !p.reason.empty(); });
    if (at == chart.points[i].end()) continue;
    text += fmt::format("  * {}: {} in {} of {} cases at {:.3g}\n", charts.lines[i].title,
                        at->reason, at->without, at->cases, at->place);
  }
  return text;
}

// "  promised: at most 1e-06 from 1 to 1000".
std::string sentence_of(const Promised& promised) {
  const auto [first, low] = promised.corners.front();
  const auto [last, high] = promised.corners.back();
  return fmt::format("  promised{}: at most {:.3g}{} from {:.3g} to {:.3g}\n",
                     promised.bonus ? " by a bonus" : "", low,
                     low == high ? "" : fmt::format(" to {:.3g}", high), first, last);
}

std::string list_of_broken(const Charts& charts, const Chart& chart) {
  std::string text;
  for (const BrokenPromise& broken : broken_promises(charts, chart)) {
    text += fmt::format("  {} breaks the promise{} at {:.3g}\n", charts.lines[broken.line].title,
                        broken.bonus ? " of the bonus" : "", broken.place);
  }
  return text;
}

std::string table(const Charts& charts, const Chart& chart) {
  std::string text = fmt::format("{}: {}\n  {}\n  by {}\n", chart.slug, chart.title,
                                 error_text(chart), chart.input);
  for (const Promised& promised : chart.promised) text += sentence_of(promised);
  std::string head = fmt::format("{:>10}", "");
  char letter = 'a';
  for (std::size_t i = 0; i < charts.lines.size(); ++i) {
    if (!is_named(charts, chart, i)) continue;
    text += fmt::format("  {}: {}\n", letter, charts.lines[i].title);
    head += fmt::format("{:>{}}", letter++, kColumn);
  }
  text += head + (chart.theory.empty() ? "" : fmt::format("{:>{}}", "theory", kColumn)) + "\n";
  for (std::size_t place = 0; place < chart.points[0].size(); ++place) {
    text += fmt::format("{:>10.3g}", chart.points[0][place].place);
    for (std::size_t i = 0; i < charts.lines.size(); ++i) {
      if (!is_named(charts, chart, i)) continue;
      const bool known = place < chart.points[i].size();
      text += fmt::format("{:>{}}", known ? cell(chart.points[i][place]) : "", kColumn);
    }
    if (!chart.theory.empty()) text += fmt::format("{:>{}.2g}", chart.theory[place], kColumn);
    text += "\n";
  }
  return text + why_none(charts, chart) + list_of_broken(charts, chart) +
         "  source: " + chart.source + "\n";
}

}  // namespace

std::string to_text(const Charts& charts) {
  std::string text;
  for (const Chart& chart : charts.charts) text += table(charts, chart) + "\n";
  for (const CurveLine& line : charts.lines) {
    if (!line.unusable.empty()) text += line.title + " is not measured: " + line.unusable + "\n";
  }
  return text;
}

}  // namespace measure::failure
