#pragma once

#include "grader/results/results.h"

#include <chrono>
#include <map>
#include <string>
#include <utility>

namespace grader::report {

// The path of each report; a report with an empty path is not written.
struct ReportFiles {
  std::string json;
  std::string html;
  std::string junit;
  std::map<std::string, std::string> autograders{};  // by the names in kAutograders
  std::string csv;
  bool small_page = false;  // of html: without the values of pixels (grader/report/html.h)
  std::string root{};       // of the project: a page below it has links to its files; empty: none
};

// Throws pt::Error if one of them could not be written.
void check_targets(const ReportFiles& files);

// Writes all reports with a path, each the whole file or none. Results of an unfinished run are
// written too; each report says that the run is unfinished. Throws pt::Error for a file that cannot be written.
void write_reports(const results::Results& results, const ReportFiles& files);

// write_reports for a run in progress. Only the page takes time: it is written so seldom that this
// takes at most a tenth of the run.
class ProgressReports {
 public:
  explicit ProgressReports(ReportFiles files) : files_(std::move(files)) {}
  void write(const results::Results& results);

 private:
  ReportFiles files_;
  std::chrono::steady_clock::time_point next_page_{};  // the first at once
};

}  // namespace grader::report
