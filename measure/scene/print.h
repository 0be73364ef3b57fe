#pragma once

#include "measure/scene/answer.h"
#include "measure/scene/converge.h"
#include "measure/scene/options.h"

#include <string>

#include <nlohmann/json.hpp>

namespace measure::scene {

// The answer in sentences and small tables, for a terminal.
std::string to_text(const Answer& answer, const Options& options, const pt::Scene& scene);

// Writes into options.out: options.csv (every way that was tried), noise.csv, bounces.csv, with
// gnuplot a chart of each, and cheapest.json.
void write_charts(const Answer& answer, const Options& options, const pt::Scene& scene);

// The numbers of both programs, for the pages of the write-up. An uncertain number is a list of
// value and standard error. Times are for the picture, cpu_seconds for the study. No choice is
// null.

nlohmann::json to_json(const Answer& answer, int surfaces, double pixels);
nlohmann::json to_json(const std::vector<MethodCurve>& curves, double pixels, double cpu_seconds);

}  // namespace measure::scene
