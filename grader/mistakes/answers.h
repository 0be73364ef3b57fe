#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace grader::mistakes {

// A task's answer to one call of its battery, or to many draws (grader/mistakes/battery.h).
struct Answer {
  std::string ended;           // "crash", "timeout", "bad reply": then there are no numbers
  std::vector<double> values;  // none: "no hit"
  std::vector<double> errors;  // the standard error of each value; empty where all are exact

  bool operator==(const Answer&) const = default;
};
using Answers = std::vector<Answer>;

// Returns whether the task looks at nothing that it is given: all answers with the same number of
// values are the same. A crash or a timeout is an answer too.
bool always_the_same(const Answers& answers);

// In JSON: "crash"; [1, 0.5], numbers that are exact; {"value": [1.02], "error": [0.03]}, means.
// Rounded to what a comparison looks at.
nlohmann::json describe(const Answer& answer);

// Throws nlohmann::json::exception for anything else.
Answer read_answer(const nlohmann::json& from);

// The answers as one line of JSON, and back. Throws pt::Error for anything else.
std::string to_json(const Answers& answers);
Answers answers_from_json(const std::string& text);

}  // namespace grader::mistakes
