#pragma once

#include "writeup/accuracy/answer.h"
#include "writeup/accuracy/converge.h"

#include <nlohmann/json.hpp>

// The numbers of both programs, for the pages of the write-up. A number that is not certain is the list of
// its value and its standard error; times are of the whole picture, but for cpu_seconds, which are those of the study; no choice is null.

namespace writeup::accuracy {

nlohmann::json to_json(const Answer& answer, int surfaces, double pixels);
nlohmann::json to_json(const std::vector<MethodCurve>& curves, double pixels, double cpu_seconds);

}  // namespace writeup::accuracy
