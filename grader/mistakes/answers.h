#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace grader::mistakes {

// The answer of a task to one call of its battery, or to many draws (grader/mistakes/battery.h).
struct Answer {
  std::string ended;  // why the task gave no values, for example "timeout"; empty otherwise
  std::vector<double> values;  // empty means "no hit"
  std::vector<double> errors;  // the standard error of each value; empty where all are exact

  bool operator==(const Answer&) const = default;
};
using Answers = std::vector<Answer>;

// Returns whether the task ignores its arguments: all answers with the same number of values are
// equal. A crash or a timeout is an answer too.
bool always_the_same(const Answers& answers);

// Returns whether the task answers every call with black, with zeros or with nothing, such as no hit: then many mistakes look alike,
// and a name would be a guess. The channels come first in an estimate; calls that are not estimates, if some are,
// ask how the sampler is used.
bool shows_nothing(const Answers& answers);

// Returns an answer as JSON: "timeout", or [1, 0.5] for exact numbers, or {"value": [1.02], "error":
// [0.03]} for means. Numbers are rounded to the digits that a comparison needs.
nlohmann::json describe(const Answer& answer);

// Reads what describe() wrote. Throws nlohmann::json::exception for anything else.
Answer read_answer(const nlohmann::json& from);

// Writes the answers as one line of JSON, and reads them back. Reading throws pt::Error for
// anything else.
std::string to_json(const Answers& answers);
Answers answers_from_json(const std::string& text);

}  // namespace grader::mistakes
