#pragma once

#include "grader/results/results.h"

#include <string>

namespace grader::results {

// Reads the text of to_json. Throws pt::Error, naming `path`, if the text is something else.
Results results_from_json(const std::string& text, const std::string& path);

// Reads the results in a file in the same way.
Results read_results(const std::string& path);

}  // namespace grader::results
