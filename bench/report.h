#pragma once

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace pt {

double median(std::vector<double> values);

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

}  // namespace pt
