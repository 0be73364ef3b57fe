#pragma once

#include "grader/results/results.h"

#include <string>

namespace grader::results {

// Returns the results as docs/results.md describes them.
std::string to_json(const Results& results);

// Writes the whole file or none: a reader never sees half of it. Throws pt::Error if it cannot be written.
void write_json(const Results& results, const std::string& path);

// Reads the text of to_json. Throws pt::Error, naming `path`, if the text is something else.
Results results_from_json(const std::string& text, const std::string& path);

// Reads the results in a file in the same way.
Results read_results(const std::string& path);

}  // namespace grader::results
