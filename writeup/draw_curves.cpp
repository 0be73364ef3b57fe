#include "grader/report/read_csv.h"
#include "pt/file.h"
#include "writeup/figure.h"
#include "writeup/files.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>

// Draws where methods fail, which the program `stability` measures, and the costs of a remedy,
// which `measure` measures.

namespace writeup {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::size_t kMaxTable = std::size_t{1} << 22;

// Two digits: "340", "2.3e6".
std::string two_digits(double value) {
  const double rounded = std::strtod(fmt::format("{:.1e}", value).c_str(), nullptr);
  const bool plain = rounded >= 1e-3 && rounded < 1e6;
  std::string text = plain ? fmt::format("{:g}", rounded) : fmt::format("{:.2g}", rounded);
  for (const auto& [long_form, short_form] : {std::pair{"e+0", "e"}, {"e+", "e"}, {"e-0", "e-"}}) {
    const std::size_t at = text.find(long_form);
    if (at != std::string::npos) text.replace(at, std::strlen(long_form), short_form);
  }
  return text;
}

// The place at which a line first passes the threshold. Between two places of the curve it is a
// straight line in the chart. From an error of 0 or to no number there is no such line: then it is the two
// places between which it fails, "65 to 260".
std::optional<std::string> passes(const json& points, double threshold) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double place = points[i].at("place");
    const json& error = points[i].at("error");
    if (!error.is_null() && error <= threshold) continue;
    if (i == 0) return two_digits(place);
    const double before = points[i - 1].at("place"), low = points[i - 1].at("error");
    if (error.is_null() || low <= 0) return two_digits(before) + " to " + two_digits(place);
    const double part = std::log(threshold / low) / std::log(error.get<double>() / low);
    return two_digits(before * std::pow(place / before, part));
  }
  return {};
}

std::string error_at(const json& point) {
  const json& error = point.at("error");
  if (error.is_null()) return "none";
  return error == 0 ? "0" : two_digits(error);
}

void enter_line(const json& line, double threshold, Drawn& drawn) {
  const std::string id = line.at("id");
  const json& points = line.at("points");
  if (points.empty()) return;
  const std::string fails = passes(points, threshold).value_or(kDash);
  double largest = 0;
  for (const json& point : points) {
    if (!point.at("error").is_null()) largest = std::max(largest, point.at("error").get<double>());
  }
  const auto enter = [&](const char* what, const std::string& value) {
    drawn.numbers[id + what] = value;
  };
  enter(".fails", fails);
  enter(".first", error_at(points.front()));
  enter(".last", error_at(points.back()));
  enter(".largest", two_digits(largest));
  enter(".from", two_digits(points.front().at("place")));
  enter(".to", two_digits(points.back().at("place")));
  drawn.rows.push_back(
      {line.at("title"), error_at(points.front()), error_at(points.back()), fails});
}

const json* find_curve(const json& all, const Figure& figure) {
  for (const json& chart : all.at("charts")) {
    const std::string slug = chart.at("slug"), name = chart.at("name");
    if (figure.curve == fmt::format("{}.{}", slug, name)) return &chart;
  }
  return nullptr;
}

}  // namespace

Drawn draw_curve(const Plan& plan, const Figure& figure, const fs::path& folder) {
  Drawn drawn;
  const Measurement measurement = plan.measurements(figure).at(0);
  if (!plan.measured().is_complete(measurement)) {
    drawn.problems.push_back(task_of(figure) + ": " + plan.measured().failure(measurement));
    return drawn;
  }
  const json all = plan.measured().load(measurement);
  for (const json& line : all.at("unusable")) {
    drawn.problems.push_back(task_of(figure) + ", " + line.at("title").get<std::string>() + ": " +
                             line.at("reason").get<std::string>());
  }
  const json* const chart = find_curve(all, figure);
  if (chart == nullptr) {
    drawn.problems.push_back("there is no curve " + figure.curve);
    return drawn;
  }
  const fs::path from = plan.measured().folder(measurement);
  take_file(from / (figure.curve + ".svg"), folder, figure.id + ".svg", drawn.charts);
  for (const char* const ending : {".csv", ".pdf", ".tex"}) {
    take_file(from / (figure.curve + ending), folder, figure.id + ending, drawn.tables);
  }
  const json& places = chart->at("lines").at(0).at("points");
  drawn.columns = {chart->at("error"), "at " + two_digits(places.front().at("place")),
                   "at " + two_digits(places.back().at("place")),
                   "first above " + two_digits(figure.threshold)};
  for (const json& line : chart->at("lines")) enter_line(line, figure.threshold, drawn);
  return drawn;
}

namespace {

using Cells = std::map<std::string, std::string>;

// The lines of measure.csv by the names of their columns.
std::vector<Cells> read_rows(const fs::path& file) {
  const grader::report::CsvTable table =
      grader::report::read_csv(pt::read_file(file, kMaxTable), file.string());
  std::vector<Cells> rows;
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    const auto &names = table.rows[0].cells, &cells = table.rows[i].cells;
    Cells& row = rows.emplace_back();
    for (std::size_t k = 0; k < std::min(names.size(), cells.size()); ++k)
      row[names[k].value] = cells[k].value;
  }
  return rows;
}

struct Factor {
  double value = 1, error = 0;
};

// The logarithm of a number in a column, and its standard error from the 95 % interval beside it.
Factor logarithm(const Cells& row, const std::string& column) {
  const auto number = [&](const char* end) { return std::stod(row.at(column + end)); };
  constexpr double kWidth = 2 * 1.96;
  return {std::log(number("")), (number("_high") - number("_low")) / kWidth / number("")};
}

// The geometric mean over the cases of a task (scenes, sizes) of the ratio of two ways in a column;
// nothing if a way has no number.
std::optional<Factor> ratio(const std::vector<Cells>& rows, const Price& price,
                            const std::string& column) {
  std::map<std::string, std::map<std::string, Factor>> numbers;  // by case and way
  for (const Cells& row : rows) {
    if (row.at("task") != price.task || !row.contains(column) || row.at(column).empty()) continue;
    std::string name = row.at("implementation");
    std::ranges::replace(name, ' ', '_');
    numbers[row.at("case")][name] = logarithm(row, column);
  }
  double sum = 0, squares = 0;
  int cases = 0;
  for (const auto& [name, of_case] : numbers) {
    if (!of_case.contains(price.plain) || !of_case.contains(price.remedy)) continue;
    const Factor &remedy = of_case.at(price.remedy), &plain = of_case.at(price.plain);
    sum += remedy.value - plain.value;
    squares += remedy.error * remedy.error + plain.error * plain.error;
    ++cases;
  }
  if (cases == 0) return {};
  const double factor = std::exp(sum / cases);
  return Factor{factor, factor * std::sqrt(squares) / cases};
}

std::string words_of(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::string times(const std::optional<Factor>& factor) {
  constexpr double kCounts = 2;  // standard errors, as in ./run ladder
  if (!factor) return kDash;
  const bool is_seen = std::abs(factor->value - 1) >= kCounts * factor->error;
  return factor_text(factor->value, factor->error) + (is_seen ? "" : ", not seen");
}

}  // namespace

Drawn draw_prices(const Plan& plan, const Figure& figure, const fs::path& folder) {
  Drawn drawn;
  const std::vector<Measurement> measurements = plan.measurements(figure);
  if (measurements.empty()) {
    // The right solutions are not in this edition.
    drawn.columns = {"what fails", "task", "remedy"};
    for (const Price& price : figure.prices) {
      drawn.rows.push_back({price.failure, price.task, words_of(price.remedy)});
    }
    return drawn;
  }
  if (!plan.measured().is_complete(measurements[0])) {
    drawn.problems.push_back(plan.measured().failure(measurements[0]));
    return drawn;
  }
  const fs::path file = plan.measured().folder(measurements[0]) / "measure.csv";
  take_file(file, folder, figure.id + ".csv", drawn.tables);
  const std::vector<Cells> rows = read_rows(file);
  drawn.columns = {"what fails", "task", "plain", "remedy", "time per call", "time × variance"};
  for (const Price& price : figure.prices) {
    const std::optional<Factor> time = ratio(rows, price, "ratio");
    const std::optional<Factor> work = ratio(rows, price, "time_x_variance");
    drawn.rows.push_back({price.failure, price.task, words_of(price.plain), words_of(price.remedy),
                          times(time), times(work)});
    if (time) drawn.numbers[price.id + ".time"] = fmt::format("{:.2f}", time->value);
    if (work) drawn.numbers[price.id + ".work"] = fmt::format("{:.2f}", work->value);
  }
  return drawn;
}

}  // namespace writeup
