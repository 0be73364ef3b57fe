#pragma once

#include "grader/report/results.h"

#include <string>

namespace grader {

// Where each report goes; an empty path: nowhere.
struct ReportFiles {
  std::string json;
  std::string html;
  std::string junit;
  std::string gradescope;
  std::string csv;
};

// Throws pt::Error if one of them could not be written.
void check_targets(const ReportFiles& files);

// Writes all that are asked for, each the whole file or none. Results of an unfinished run are
// written too; each report says that it is one. Throws pt::Error for a file that cannot be written.
void write_reports(const Results& results, const ReportFiles& files);

}  // namespace grader
