#pragma once

#include "writeup/stability/lines.h"

namespace writeup::stability {

// Searches for the inputs on which a task is furthest from an exact oracle, and prints the worst ones.
// The worst inputs are kept in `folder`, a file per task and submission. Returns whether it could be
// tried.
bool search_all(const grader::judge::Config& config, const grader::judge::TaskConfig& task,
                const Request& request, double minutes, const std::string& folder);

// Returns whether the task has searches.
bool has_searches(const grader::judge::Config& config, const grader::judge::TaskConfig& task);

}  // namespace writeup::stability
