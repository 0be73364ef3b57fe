#pragma once

#include "grader/results/changes.h"

#include <string>
#include <vector>

namespace grader::platforms {

// A class that was graded twice: the same submissions, by another judge or with other points.
struct Comparison {
  struct Row {
    std::string name;
    std::string page;                // the file of its report, next to the page; may be empty
    int before = 0, max_before = 0;  // points with bonus, maximum without bonus
    int after = 0, max_after = 0;
    std::vector<results::Change> changes;
  };
  std::string former;                    // the folder of the earlier reports
  std::vector<Row> rows;                 // submissions that were judged both times
  std::vector<std::string> only_before;  // names of submissions that were judged only once
  std::vector<std::string> only_after;
};

// A table (RFC 4180) of the submissions that gain or lose points, a line per change: submission,
// its points before and after, task, promise, and its points before and after.
std::string comparison_csv(const Comparison& comparison);

// The page: one file, readable without network and scripts.
std::string comparison_html(const Comparison& comparison);

// "3 gain points, 1 loses points, 46 have the same."
std::string comparison_sentence(const Comparison& comparison);

}  // namespace grader::platforms
