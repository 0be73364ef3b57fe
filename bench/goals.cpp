#include "bench/goals.h"

#include <cstdio>

namespace pt {

void print_goals(const std::vector<Goal>& goals, Csv& csv) {
  std::printf("\ngoals\n");
  for (const Goal& goal : goals) {
    const bool met = goal.factor() >= 1;
    std::printf("  %-54s %6.2f, wanted %s %g: ", goal.what.c_str(), goal.measured,
                goal.lower_is_better ? "at most" : "at least", goal.wanted);
    if (met) {
      std::printf("met\n");
    } else {
      std::printf("missed by a factor of %.2f\n", 1 / goal.factor());
    }
    char row[300];
    std::snprintf(row, sizeof row, "%s,%g,%.3f,%s", goal.what.c_str(), goal.wanted, goal.measured,
                  met ? "met" : "missed");
    csv.row(row);
  }
}

}  // namespace pt
