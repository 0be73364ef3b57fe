#include "grader/service/platforms/compare_page.h"

#include "grader/report/csv.h"
#include "grader/report/filled.h"
#include "grader/report/page/sources.h"
#include "grader/results/presentable.h"
#include "grader/service/platforms/page/sources.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grader::platforms {

namespace {

using kainjow::mustache::data;
using Row = Comparison::Row;
using report::csv_field;

// "+3", "−1" with a true minus sign, "0".
std::string signed_text(int points) {
  if (points == 0) return "0";
  return fmt::format("{}{}", points > 0 ? "+" : "\u2212", std::abs(points));
}

// The number of submissions whose points changed because of one promise.
struct Cause {
  std::string slug, what;
  int gain = 0, lose = 0, points = 0;
};

std::vector<Cause> causes_of(const Comparison& comparison) {
  std::map<std::pair<std::string, std::string>, Cause> causes;
  for (const Row& row : comparison.rows) {
    for (const results::Change& change : row.changes) {
      Cause& cause = causes[{change.slug, change.what}];
      cause.slug = change.slug;
      cause.what = change.what;
      ++(change.after > change.before ? cause.gain : cause.lose);
      cause.points += change.after - change.before;
    }
  }
  std::vector<Cause> all;
  for (const auto& [key, cause] : causes) all.push_back(cause);
  std::ranges::stable_sort(all, std::greater{},
                           [](const Cause& cause) { return cause.gain + cause.lose; });
  return all;
}

data row_data(const Row& row) {
  data out, changes{data::type::list};
  for (const results::Change& change : row.changes) {
    data each;
    each.set("slug", change.slug);
    each.set("what", results::one_line(change.what));
    each.set("points", signed_text(change.after - change.before));
    changes.push_back(each);
  }
  out.set("name", results::one_line(row.name));
  out.set("address", report::address_of(row.page));
  out.set("before", fmt::format("{} of {}", row.before, row.max_before));
  out.set("after", fmt::format("{} of {}", row.after, row.max_after));
  out.set("difference", signed_text(row.after - row.before));
  out.set("tone", row.after > row.before ? "pass" : row.after < row.before ? "fault" : "quiet");
  out.set("changes", changes);
  return out;
}

data text_or_nothing(const std::vector<std::string>& names) {
  if (names.empty()) return false;
  return results::one_line(fmt::format("{}", fmt::join(names, ", ")));
}

}  // namespace

std::string comparison_sentence(const Comparison& comparison) {
  const auto count = [&](auto is) { return std::ranges::count_if(comparison.rows, is); };
  const auto gain = count([](const Row& row) { return row.after > row.before; });
  const auto lose = count([](const Row& row) { return row.after < row.before; });
  return fmt::format("{} gain{} points, {} lose{} points, {} ha{} the same.", gain,
                     gain == 1 ? "s" : "", lose, lose == 1 ? "s" : "",
                     static_cast<long>(comparison.rows.size()) - gain - lose,
                     static_cast<long>(comparison.rows.size()) - gain - lose == 1 ? "s" : "ve");
}

std::string comparison_csv(const Comparison& comparison) {
  std::string text = std::string(report::kByteOrderMark) +
                     "submission,points_before,max_before,points,max_points,task,promise,"
                     "promise_before,promise_after\r\n";
  for (const Row& row : comparison.rows) {
    for (const results::Change& change : row.changes) {
      text += fmt::format("{},{},{},{},{},{},{},{},{}\r\n", csv_field(row.name), row.before,
                          row.max_before, row.after, row.max_after, csv_field(change.slug),
                          csv_field(change.what), change.before, change.after);
    }
  }
  return text;
}

std::string comparison_html(const Comparison& comparison) {
  data out, causes{data::type::list}, rows{data::type::list};
  for (const Cause& cause : causes_of(comparison)) {
    data each;
    each.set("slug", cause.slug);
    each.set("what", results::one_line(cause.what));
    each.set("gain", std::to_string(cause.gain));
    each.set("lose", std::to_string(cause.lose));
    each.set("points", signed_text(cause.points));
    causes.push_back(each);
  }
  std::vector<Row> changed;
  for (const Row& row : comparison.rows) {
    if (!row.changes.empty() || row.before != row.after) changed.push_back(row);
  }
  std::ranges::stable_sort(changed, {}, [](const Row& row) { return row.after - row.before; });
  for (const Row& row : changed) rows.push_back(row_data(row));
  out.set("style", std::string(report::page_css));
  out.set("sentence", comparison_sentence(comparison));
  out.set("compared", std::to_string(comparison.rows.size()));
  out.set("former", results::one_line(comparison.former));
  out.set("has_causes", !changed.empty());
  out.set("causes", causes);
  out.set("rows", rows);
  out.set("only_before", text_or_nothing(comparison.only_before));
  out.set("only_after", text_or_nothing(comparison.only_after));
  return report::filled(compare_html, out);
}

}  // namespace grader::platforms
