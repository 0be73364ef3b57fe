#pragma once

#include "writeup/measure/ranged.h"
#include "writeup/measure/tasks.h"

#include <string>
#include <vector>

namespace writeup::measure {

// The measurements of one candidate in one case of its task.
struct Row {
  std::string name;
  bool is_own = false;
  std::string problem;  // a sentence in place of all numbers
  Ranged nanoseconds;   // of processor time, per call
  Ranged ratio;         // to the reference's batches before and after, {1, 1, 1} for itself
  int batches = 0;
  Found found;
  Ranged mean;      // of estimators, over the true one
  Ranged variance;  // of one call, over the squared true mean
};

struct Table {
  std::string name;  // of the case; empty where there is only one
  std::vector<Row> rows;
};

struct Results {
  const About* about = nullptr;
  std::vector<Table> tables;  // in the order of about->cases
};

// Beside time, what is charted: the error, the noise (standard deviation of a call), tests per ray. Largest errors
// of other inputs may be half or twice as large; that is the interval.
Ranged accuracy(const About& about, const Row& row);

// Answers that a right solution does not give: a sentence on them, or nothing.
std::string mistake(const About& about, const Row& row);

// For each row of each table whether no right row beats it: is clearly better in time or accuracy, and not clearly
// worse in the other. Tables are compared with themselves, or all together where they have one front.
std::vector<std::vector<bool>> pareto_fronts(const About& about, const std::vector<Table>& tables);

// The work of an estimator: time x variance, over that of the reference.
Ranged work(const Row& row, const Row& reference);

}  // namespace writeup::measure
