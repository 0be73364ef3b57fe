#include "measure/calls/print.h"
#include "measure/charts/numbers.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace measure::calls {

namespace {

using Cells = std::vector<std::string>;

// "31.4 ± 0.2", in units of `unit`, with the digits that the interval makes certain.
std::string ranged(const Ranged& number, double unit = 1) {
  const double half = (number.high - number.low) / 2 / unit, value = number.value / unit;
  if (!(half > 0)) return fmt::format("{:.3g}", value);
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(half))), 0, 4);
  return fmt::format("{:.{}f} ± {:.{}f}", value, digits, half, digits);
}

std::string error_text(double error) { return error > 0 ? fmt::format("{:.1e}", error) : "0"; }

Cells headings(const Results& results, const Unit& unit, bool has_rays) {
  const About& about = *results.about;
  Cells cells{fmt::format("{} per call", unit.name), "x reference"};
  if (about.kind == Kind::estimator) {
    cells.insert(cells.end(), {"noise", "time x variance"});
    if (has_rays) cells.emplace_back("rays");
    if (about.chooses_samples) cells.emplace_back("samples");
  } else if (about.kind == Kind::tree) {
    cells.insert(cells.end(), {"boxes", "triangles"});
  }
  cells.insert(cells.end(), about.errors.begin(), about.errors.end());
  return cells;
}

Cells numbers(const About& about, const Row& row, const Row& reference, const Unit& unit,
              bool has_rays) {
  Cells cells{ranged(row.nanoseconds, unit.nanoseconds), ranged(row.ratio)};
  if (about.kind == Kind::estimator) {
    cells.push_back(percent(accuracy(about, row).value));
    cells.push_back(ranged(work(row, reference)));
    if (has_rays) cells.push_back(fmt::format("{:.3g}", row.found.rays));
    if (about.chooses_samples) cells.push_back(fmt::format("{:.4g}", row.found.samples));
  } else if (about.kind == Kind::tree) {
    cells.push_back(fmt::format("{:.2f}", row.found.boxes));
    cells.push_back(fmt::format("{:.2f}", row.found.primitives));
  }
  for (std::size_t i = 0; i < about.errors.size(); ++i)
    cells.push_back(error_text(row.found.errors.at(i)));
  return cells;
}

std::string padded(const Cells& cells) {
  std::string text;
  for (const std::string& cell : cells) text += fmt::format("{:>18}", cell);
  return text;
}

std::string table_text(const Results& results, const Table& table, const std::vector<bool>& front) {
  const About& about = *results.about;
  const Row& reference = table.rows[0];
  const Unit unit = unit_of(reference.nanoseconds.value);
  const bool has_rays = reference.found.rays > 0;
  std::size_t width = table.name.size();
  for (const Row& row : table.rows) width = std::max(width, row.name.size());
  std::string text =
      fmt::format("  {:<{}}{}\n", table.name, width, padded(headings(results, unit, has_rays)));
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Row& row = table.rows[i];
    text += fmt::format("{} {:<{}}", front[i] ? '*' : ' ', row.name, width);
    if (!row.problem.empty()) {
      text += "  " + row.problem + "\n";
      continue;
    }
    const std::string wrong = mistake(about, row);
    text += padded(numbers(about, row, reference, unit, has_rays)) +
            (wrong.empty() ? "" : "  " + wrong) + "\n";
  }
  return text;
}

// Breaks sentences into lines for a terminal.
std::string wrapped(const std::string& text) {
  constexpr std::size_t kWidth = 100;
  std::string lines = "  ";
  std::size_t column = 2;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    if (column + end - at > kWidth) {
      lines += "\n  ";
      column = 2;
    }
    lines += text.substr(at, end - at) + ' ';
    column += end - at + 1;
    at = end + 1;
  }
  lines.pop_back();
  return lines + '\n';
}

}  // namespace

Unit unit_of(double nanoseconds) {
  if (nanoseconds < 1e4) return {"ns", 1};
  return nanoseconds < 1e6 ? Unit{"us", 1e3} : Unit{"ms", 1e6};
}

std::string to_text(const Results& results) {
  const auto front = pareto_fronts(*results.about, results.tables);
  std::string text = results.about->slug + "\n" + wrapped(results.about->inputs);
  for (std::size_t i = 0; i < results.tables.size(); ++i) {
    text += '\n' + table_text(results, results.tables[i], front[i]);
  }
  return text + '\n';
}

}  // namespace measure::calls
