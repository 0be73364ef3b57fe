#pragma once

#include "grader/process/run_command.h"

#include <string>

// The output of a compiler or a linker, as a learner reads it.

namespace grader::judge {

// The warnings about the file itself, each with the lines that explain it; 40 lines at most.
std::string warnings_of(const std::string& output, const std::string& file);

// The first error with the lines that explain it, 12 lines at most; or, in a sentence, how it ended
// without one. `seconds`: its limit.
std::string first_error(const process::CommandResult& result, int seconds);

// The output with headers by their places in the project ("pt/math/vec3.h"): a report says no path of
// this machine. `tree`: the folder in which the compiler found pt/; lines that name a file in the
// folder `own`, of the judge, are left out.
std::string in_project(const std::string& output, const std::string& tree, const std::string& own);

// The output of a linker without the judge's files, which are in the folder `own`: of lines that name one, what is missing.
std::string without_parts(const std::string& output, const std::string& own);

}  // namespace grader::judge
