#pragma once

#include "bench/report.h"

#include <string>
#include <vector>

namespace pt {

// What was reached for, and what was measured: `at_least` or, where `lower_is_better`, at most.
struct Goal {
  std::string what;
  double wanted;
  double measured;
  bool lower_is_better = false;

  // How many times better than wanted; missed below 1.
  double factor() const { return lower_is_better ? wanted / measured : measured / wanted; }
};

// A line for each on the terminal, and a row in the CSV.
void print_goals(const std::vector<Goal>& goals, Csv& csv);

}  // namespace pt
