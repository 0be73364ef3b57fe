#pragma once

#include "bench/report.h"

#include <string>
#include <vector>

namespace pt {

// A goal and its measurement, which has to be at least `wanted` or, where `lower_is_better`, at
// most.
struct Goal {
  std::string what;
  double wanted;
  double measured;
  bool lower_is_better = false;

  // The factor by which it is better than wanted; below 1 the goal is missed.
  double factor() const { return lower_is_better ? wanted / measured : measured / wanted; }
};

// A line for each on the terminal, and a row in the CSV.
void print_goals(const std::vector<Goal>& goals, Csv& csv);

}  // namespace pt
