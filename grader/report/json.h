#pragma once

#include "grader/report/results.h"

#include <string>

namespace grader {

// The results as docs/results.md describes them.
std::string to_json(const Results& results);

// Writes them next to `path` and renames: a reader never sees half a file. Throws pt::Error if the
// file cannot be written.
void write_json(const Results& results, const std::string& path);

}  // namespace grader
