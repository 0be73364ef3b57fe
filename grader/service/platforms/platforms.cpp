#include "grader/service/platforms/platforms.h"

#include "grader/report/csv.h"
#include "grader/results/presentable.h"

#include <algorithm>

#include <fmt/format.h>

namespace grader::platforms {

namespace {

using report::csv_field;

std::string points_field(const GradeRow& row) {
  return row.judged ? std::to_string(row.points) : "";
}

}  // namespace

std::string canvas_csv(const std::vector<GradeRow>& rows, const std::string& assignment,
                       int max_points) {
  std::string text =
      fmt::format("Student,ID,SIS User ID,SIS Login ID,Section,{}\r\n", csv_field(assignment));
  text += fmt::format("    Points Possible,,,,,{}\r\n", max_points);
  for (const GradeRow& row : rows) {
    if (row.id.empty()) continue;
    text +=
        fmt::format("{},{},,,,{}\r\n", csv_field(row.name), csv_field(row.id), points_field(row));
  }
  return text;
}

std::string moodle_csv(const std::vector<GradeRow>& rows, int max_points) {
  std::string text =
      "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,"
      "Last modified (submission),Last modified (grade),Feedback comments\r\n";
  for (GradeRow row : rows) {
    if (row.id.empty()) continue;
    row.points = std::min(row.points, max_points);
    text += fmt::format("Participant {},{},,,{},{},Yes,-,-,{}\r\n", results::one_line(row.id),
                        csv_field(row.name), points_field(row), max_points, csv_field(row.comment));
  }
  return text;
}

std::string gradescope_csv(const std::vector<GradeRow>& rows, int max_points) {
  std::string text = std::string(report::kByteOrderMark) + "Name,ID,Points,Max Points,Comment\r\n";
  for (const GradeRow& row : rows) {
    text += fmt::format("{},{},{},{},{}\r\n", csv_field(row.name), csv_field(row.id),
                        points_field(row), max_points, csv_field(row.comment));
  }
  return text;
}

}  // namespace grader::platforms
