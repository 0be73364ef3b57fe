#pragma once

#include "grader/service/process/run_command.h"

#include <string>

// The output of a compiler or a linker, as a learner reads it.

namespace grader::build {

// The warnings about the file itself, each with the lines that explain it; 40 lines at most.
std::string warnings_of(const std::string& output, const std::string& file);

// The first error with the lines that explain it, 12 lines at most. Without an error: a sentence on
// how the compiler ended. `seconds` is its time limit.
std::string first_error(const process::CommandResult& result, int seconds);

// The output with headers named by their places in the project ("pt/math/vec3.h"), because a report
// shows no path of this machine, and is the same in each run. `tree` is the folder in which the
// compiler found pt/. Lines that name a file in the judge's folder `own` are left out.
std::string in_project(const std::string& output, const std::string& tree, const std::string& own);

// The output of a linker; lines that name a file in the judge's folder `own` keep only the error.
std::string without_parts(const std::string& output, const std::string& own);

}  // namespace grader::build
