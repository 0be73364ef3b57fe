#pragma once

#include "grader/results/results.h"

#include <string>
#include <vector>

namespace grader::results {

// A promise, a picture, or a rule of the points that earns another number of points than before.
struct Change {
  std::string slug;  // of the task
  std::string what;  // the words of the promise, the title of the picture, or the rule
  int before = 0;
  int after = 0;

  bool operator==(const Change&) const = default;
};

// All changes from one verdict on a submission to another one, in the order of the course. Their
// differences add up to that of the points, bonus points included. A promise or picture that only
// one of the verdicts has earns 0 in the other.
std::vector<Change> changes(const Results& before, const Results& after);

}  // namespace grader::results
