#pragma once

#include "measure/scene/answer.h"
#include "measure/scene/options.h"

#include <string>

namespace measure::scene {

// "12.3 %".
std::string percent(double part);

// The answer in sentences and small tables, for a terminal.
std::string to_text(const Answer& answer, const Options& options, const pt::Scene& scene);

// Writes into options.out: options.csv (every way that was tried), noise.csv, bounces.csv, with
// gnuplot a chart of each, and cheapest.json.
void write_charts(const Answer& answer, const Options& options, const pt::Scene& scene);

}  // namespace measure::scene
