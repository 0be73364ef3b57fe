#pragma once

#include "measure/scene/answer.h"
#include "measure/scene/converge.h"

#include <nlohmann/json.hpp>

// The numbers of both programs, for the pages of the write-up. An uncertain number is a list of
// value and standard error. Times are for the picture, cpu_seconds for the study. No choice is
// null.

namespace measure::scene {

nlohmann::json to_json(const Answer& answer, int surfaces, double pixels);
nlohmann::json to_json(const std::vector<MethodCurve>& curves, double pixels, double cpu_seconds);

}  // namespace measure::scene
