#include "bench/report.h"

#include "pt/error.h"
#include "pt/math/uncertain.h"
#include "pt/render/cpu_time.h"

#include <algorithm>
#include <cstdio>

namespace pt {

std::vector<std::vector<double>> interleave(const std::vector<std::function<void()>>& contenders,
                                            int rounds) {
  std::vector<std::vector<double>> seconds(contenders.size());
  for (int round = -1; round < rounds; ++round) {
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      const double start = thread_cpu_seconds();
      contenders[i]();
      if (round >= 0) seconds[i].push_back(thread_cpu_seconds() - start);
    }
  }
  return seconds;
}

Ratio ratio(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
  const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
  return {median_of(ratios), *least, *most};
}

Csv::Csv(const std::string& file, const std::string& header)
    : file_(std::fopen(file.c_str(), "w")) {
  if (!file_) throw Error("cannot write " + file + ": choose another folder with --out");
  row(header);
}

Csv::~Csv() { std::fclose(file_); }

void Csv::row(const std::string& line) {
  std::fprintf(file_, "%s\n", line.c_str());
  std::fflush(file_);
}

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
    std::snprintf(row, sizeof row, "\"%s\",%g,%.3f,%s", goal.what.c_str(), goal.wanted,
                  goal.measured, met ? "met" : "missed");
    csv.row(row);
  }
}

}  // namespace pt
