#pragma once

#include "measure/calls/tasks.h"

#include <string>
#include <vector>

namespace measure::calls {

// A number, and its 95 % interval.
struct Ranged {
  double value = 0;
  double low = 0;
  double high = 0;
};

// The interval ends at two of the values, for any distribution (David and Nagaraja 2003, Order
// Statistics, section 7.1). For fewer than six values these are the smallest and the largest.
Ranged median_of(std::vector<double> values);

// The mean of two or more independent values.
Ranged mean_of(const std::vector<double>& values);

// Both are positive and independent.
Ranged product(const Ranged& a, const Ranged& b);

// The measurements of one candidate in one case of its task.
struct Row {
  std::string name;
  bool is_own = false;
  std::string problem;  // a sentence instead of all numbers
  Ranged nanoseconds;   // of processor time, per call
  Ranged ratio;         // to the reference's batches before and after, {1, 1, 1} for itself
  int batches = 0;
  Found found;
  Ranged mean;      // of estimators, over the true mean
  Ranged variance;  // of one call, over the squared true mean
};

struct Table {
  std::string name;  // of the case; empty if there is only one case
  std::vector<Row> rows;
};

struct Results {
  const About* about = nullptr;
  std::vector<Table> tables;  // in the order of about->cases
};

// The quantity charted against time: the error, the noise (standard deviation of a call), or tests
// per ray. With other inputs the largest error may be half or twice as large: that is its interval.
Ranged accuracy(const About& about, const Row& row);

// A sentence on answers that a right solution does not give; empty if there are none.
std::string mistake(const About& about, const Row& row);

// Returns whether somebody's own code gave no numbers (it crashed, did not end, is not written) or
// wrong answers.
bool own_code_fails(const Results& results);

// For each row of each table: whether no right row beats it. It would be clearly better in time or
// accuracy, and not clearly worse in the other. Tables with one front are compared together.
std::vector<std::vector<bool>> pareto_fronts(const About& about, const std::vector<Table>& tables);

// The work of an estimator: time x variance, over the reference's.
Ranged work(const Row& row, const Row& reference);

}  // namespace measure::calls
