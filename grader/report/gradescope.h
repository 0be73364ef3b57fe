#pragma once

#include "grader/results/results.h"

#include <string>

namespace grader::report {

// The results.json that Gradescope reads (its autograder documentation, "Output Format"): one test
// per task, all visible, in plain text. Bonus points are part of a task's score, which may then exceed
// its maximum. The file of an unfinished run is complete too, and has a sentence above the tests.
std::string to_gradescope(const results::Results& results);

}  // namespace grader::report
