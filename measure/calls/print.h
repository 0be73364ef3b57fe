#pragma once

#include "measure/calls/results.h"

#include <filesystem>
#include <string>
#include <vector>

namespace measure::calls {

// A unit in which times of about this many nanoseconds are short numbers.
struct Unit {
  const char* name = "ns";
  double nanoseconds = 1;
};
Unit unit_of(double nanoseconds);

// The numbers for a terminal.
std::string to_text(const Results& results);

// A line for each row of each table.
std::string to_csv(const std::vector<Results>& all);

// With gnuplot: one chart of the task, or one per case, of time against error, noise or tests per
// ray. It shows the front of the candidates that no other candidate beats in both.
void draw_charts(const Results& results, const std::filesystem::path& folder);

}  // namespace measure::calls
