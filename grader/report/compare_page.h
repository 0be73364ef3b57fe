#pragma once

#include "grader/results/changes.h"

#include <string>
#include <vector>

namespace grader::report {

// A class that was graded twice: the same submissions, by another judge or with other points.
struct Comparison {
  struct Row {
    std::string name;
    std::string page;  // the file of its report, beside the page; empty if there is none
    int before = 0, max_before = 0;  // points, bonus points included; without them
    int after = 0, max_after = 0;
    std::vector<results::Change> changes;
  };
  std::string former;                    // the folder of the earlier reports
  std::vector<Row> rows;                 // of all that were judged both times
  std::vector<std::string> only_before;  // names: judged in one of the two gradings only
  std::vector<std::string> only_after;
};

// The submissions that gain and lose, and by what. A table (RFC 4180), a line for each change: submission, points before and
// after; task, promise, and its points before and after.
std::string comparison_csv(const Comparison& comparison);

// One file, which needs no network and no script.
std::string comparison_html(const Comparison& comparison);

// "3 gain points, 1 loses points, 46 have the same."
std::string comparison_sentence(const Comparison& comparison);

}  // namespace grader::report
