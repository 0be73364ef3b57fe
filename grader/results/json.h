#pragma once

#include "grader/results/results.h"

#include <string>

namespace grader::results {

// Returns the results as docs/results.md describes them.
std::string to_json(const Results& results);

// Writes the whole file or none: a reader never sees half of it. Throws pt::Error if it cannot be written.
void write_json(const Results& results, const std::string& path);

}  // namespace grader::results
