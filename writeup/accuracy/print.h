#pragma once

#include "writeup/accuracy/answer.h"
#include "writeup/accuracy/options.h"

#include <string>

namespace writeup::accuracy {

// The answer in sentences and small tables, for a terminal.
std::string to_text(const Answer& answer, const Options& options, const pt::Scene& scene);

// Writes into options.out: options.csv (every way that was tried), noise.csv, bounces.csv, a chart of each where there is
// gnuplot, and cheapest.json.
void write_charts(const Answer& answer, const Options& options, const pt::Scene& scene);

}  // namespace writeup::accuracy
