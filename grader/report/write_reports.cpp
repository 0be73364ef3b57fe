#include "grader/report/write_reports.h"

#include "grader/report/csv.h"
#include "grader/report/gradescope.h"
#include "grader/report/html.h"
#include "grader/report/junit.h"
#include "grader/results/json.h"
#include "grader/results/presentable.h"
#include "pt/file.h"

namespace grader::report {

void check_targets(const ReportFiles& files) {
  for (const std::string* path :
       {&files.json, &files.html, &files.junit, &files.gradescope, &files.csv}) {
    if (!path->empty()) pt::check_target(*path);
  }
}

void write_reports(const results::Results& results, const ReportFiles& files) {
  if (!files.json.empty()) results::write_json(results::presentable(results), files.json);
  if (!files.junit.empty()) pt::write_file(files.junit, to_junit(results));
  if (!files.gradescope.empty()) pt::write_file(files.gradescope, to_gradescope(results));
  if (!files.csv.empty()) pt::write_file(files.csv, to_csv(results));
  const PageSize size = files.small_page ? PageSize::small : PageSize::full;
  if (!files.html.empty()) pt::write_file(files.html, to_html(results, size));
}

void ProgressReports::write(const results::Results& results) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const bool with_page = results.complete || start >= next_page_;
  ReportFiles files = files_;
  if (!with_page) files.html.clear();
  write_reports(results, files);
  const auto end = Clock::now();
  if (with_page) next_page_ = end + 9 * (end - start);
}

}  // namespace grader::report
