#pragma once

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace pt {

// Runs all contenders in turn, once to warm up and then `rounds` times. Returns the seconds of each
// round: [contender][round]. Contenders run within moments of each other, so other load on the
// machine affects all of them.
std::vector<std::vector<double>> interleave(const std::vector<std::function<void()>>& contenders,
                                            int rounds);

// The speed of b as a multiple of the speed of a, over the rounds.
struct Ratio {
  double median;
  double least;
  double most;
};
Ratio ratio(const std::vector<double>& a, const std::vector<double>& b);

// A table as comma-separated values, a line per row.
class Csv {
 public:
  Csv(const std::string& file, const std::string& header);
  ~Csv();
  Csv(const Csv&) = delete;
  Csv& operator=(const Csv&) = delete;

  void row(const std::string& line);

 private:
  std::FILE* file_;
};

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
