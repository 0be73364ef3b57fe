#pragma once

#include "writeup/measure/results.h"

#include <filesystem>
#include <string>
#include <vector>

namespace writeup::measure {

// A unit in which times of about so many nanoseconds are short numbers.
struct Unit {
  const char* name = "ns";
  double nanoseconds = 1;
};
Unit unit_of(double nanoseconds);

// The numbers for a terminal.
std::string to_text(const Results& results);

// A line for each row of each table.
std::string to_csv(const std::vector<Results>& all);

// One chart of the task, or one for each of its cases, where there is gnuplot: time against error, noise or tests
// per ray, with the front of those that no other one beats in both.
void draw_charts(const Results& results, const std::filesystem::path& folder);

}  // namespace writeup::measure
