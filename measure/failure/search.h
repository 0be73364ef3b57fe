#pragma once

#include "measure/failure/lines.h"

namespace measure::failure {

// Searches for the inputs on which a task is furthest from an exact oracle, and prints the worst
// ones. The worst inputs are kept in `folder`, one file per task and submission. Returns whether
// the task could be searched.
bool search_all(const grader::build::Config& config, const grader::build::TaskConfig& task,
                const Request& request, double minutes, const std::string& folder);

// Returns whether the task has searches.
bool has_searches(const grader::build::Config& config, const grader::build::TaskConfig& task);

}  // namespace measure::failure
