#pragma once

#include "measure/failure/lines.h"

#include <filesystem>
#include <string>

namespace measure::failure {

// The quantity, and of how many cases it is: "error of t, the largest of 200 cases".
std::string error_text(const Chart& chart);

// A table of each chart for a terminal: a row per place; columns for the reference, the submission, and
// the methods that the chart is about.
std::string to_text(const Charts& charts);

// Writes <slug>.<curve>.csv with all lines, and with gnuplot a chart.
void write_charts(const Charts& charts, const std::filesystem::path& folder);

// The lines that the charts are about, with their numbers, for programs.
std::string to_json(const std::vector<Charts>& tasks, double cpu_seconds);

}  // namespace measure::failure
