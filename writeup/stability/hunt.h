#pragma once

#include "writeup/stability/lines.h"

namespace writeup::stability {

// Searches for the inputs on which a task is furthest from an exact oracle, and prints the worst ones.
// What was found is kept in `folder`, a file per task and submission. Returns whether it could be
// tried.
bool hunt(const grader::judge::Config& config, const grader::judge::TaskConfig& task,
          const Request& request, double minutes, const std::string& folder);

// Whether the task has searches.
bool has_searches(const grader::judge::Config& config, const grader::judge::TaskConfig& task);

}  // namespace writeup::stability
