#pragma once

#include "bench/report.h"

#include <string>
#include <vector>

namespace pt {

// A goal. The measurement has to be at least `wanted`, or at most if `lower_is_better`.
struct Goal {
  std::string what;
  double wanted;
  double measured;
  bool lower_is_better = false;

  // The factor by which the measurement is better than wanted. Below 1 the goal is missed.
  double factor() const { return lower_is_better ? wanted / measured : measured / wanted; }
};

// Prints a line for each goal, and adds a row to the CSV.
void print_goals(const std::vector<Goal>& goals, Csv& csv);

}  // namespace pt
