#include "grader/report/csv.h"

#include "grader/results/presentable.h"
#include "grader/results/summary.h"

#include <fmt/format.h>

namespace grader::report {

namespace {

// A formula starts with a sign, plain or in full width, perhaps after blanks.
bool starts_formula(const std::string& text) {
  for (const char* sign : {"=", "+", "-", "@", " ", "\uff1d", "\uff0b", "\uff0d", "\uff20"}) {
    if (text.starts_with(sign)) return true;
  }
  return false;
}

}  // namespace

std::string csv_field(const std::string& text) {
  const std::string line = results::one_line(text);
  std::string escaped = starts_formula(line) ? "'" : "";
  for (const char c : line) escaped += c == '"' ? std::string("\"\"") : std::string(1, c);
  return escaped.find_first_of(",;\"") == std::string::npos ? escaped : '"' + escaped + '"';
}

std::string to_csv(const results::Results& raw) {
  const results::Results results = results::presentable(raw);
  std::string text =
      std::string(kByteOrderMark) +
      "submission,number,task,state,points,max_points,bonus_points,seconds,complete\r\n";
  for (const results::TaskResult& task : results.tasks) {
    text +=
        fmt::format("{},{},{},{},{},{},{},{:.2f},{}\r\n", csv_field(results.submission),
                    csv_field(task.number), csv_field(task.slug), name(task.state), task.points,
                    task.max_points, task.bonus_points, results::seconds(task), results.complete);
  }
  return text;
}

}  // namespace grader::report
