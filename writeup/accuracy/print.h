#pragma once

#include "writeup/accuracy/answer.h"
#include "writeup/accuracy/options.h"

#include <filesystem>
#include <string>

namespace writeup::accuracy {

// The answer in sentences and small tables, for a terminal.
std::string to_text(const Answer& answer, const Options& options, const pt::Scene& scene);

// Writes options.csv (every way that was tried), noise.csv, bounces.csv, and a chart of each where
// there is gnuplot.
void write_charts(const Answer& answer, const Options& options,
                  const std::filesystem::path& folder);

}  // namespace writeup::accuracy
