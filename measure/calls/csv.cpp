#include "grader/report/csv.h"

#include "measure/calls/print.h"

#include <fmt/format.h>

namespace measure::calls {

namespace {

std::string columns(const Ranged& number) {
  return fmt::format("{:.6g},{:.6g},{:.6g}", number.value, number.low, number.high);
}

using grader::report::csv_field;

// Numbers that do not exist for the task stay empty.
std::string line(const About& about, const Table& table, const Row& row, bool best) {
  std::string text = fmt::format("{},{},{},{},", about.slug, csv_field(table.name),
                                 csv_field(row.name), best ? 1 : 0);
  if (!row.problem.empty()) return text + std::string(23, ',') + csv_field(row.problem) + '\n';
  text += fmt::format("{},{},{},", columns(row.nanoseconds), columns(row.ratio), row.batches);
  for (int i = 0; i < kMaxErrors; ++i) {
    const bool named = i < static_cast<int>(about.errors.size());
    text += named ? fmt::format("{:.3g},", row.found.errors.at(i)) : ",";
  }
  const bool noisy = about.kind == Kind::estimator, tree = about.kind == Kind::tree;
  text += noisy ? fmt::format("{},{},{},", columns(row.variance), columns(row.mean),
                              columns(work(row, table.rows[0])))
                : std::string(9, ',');
  const auto known = [](bool is, double value) { return is ? fmt::format("{:.6g}", value) : ""; };
  text += known(noisy, row.found.rays) + ',' + known(tree, row.found.boxes) + ',' +
          known(tree, row.found.primitives) + ',' +
          known(about.chooses_samples, row.found.samples) + ',';
  return text + csv_field(mistake(about, row)) + '\n';
}

}  // namespace

std::string to_csv(const std::vector<Results>& all) {
  std::string text =
      "task,case,implementation,front,nanoseconds,nanoseconds_low,nanoseconds_high,ratio,ratio_low,"
      "ratio_high,"
      "batches,error_1,error_2,error_3,variance,variance_low,variance_high,mean,mean_low,mean_high,"
      "time_x_variance,time_x_variance_low,time_x_variance_high,rays,boxes,primitives,samples,"
      "problem\n";
  for (const Results& results : all) {
    const auto front = pareto_fronts(*results.about, results.tables);
    for (std::size_t i = 0; i < results.tables.size(); ++i) {
      const Table& table = results.tables[i];
      for (std::size_t k = 0; k < table.rows.size(); ++k) {
        text += line(*results.about, table, table.rows[k], front[i][k]);
      }
    }
  }
  return text;
}

}  // namespace measure::calls
