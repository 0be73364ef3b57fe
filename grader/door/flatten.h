#pragma once

#include "grader/door/clone.h"
#include "grader/door/texts.h"

#include <string>

namespace grader::door {

// One file with all that the task needs: the learner's own source and headers, with #line, so that
// messages name the learner's file and line, between the adapter's parts. If the function is not
// written yet, the task says so.
std::string flatten(const Clone& clone, const Texts& texts, const std::string& slug);

// The functions of the learner's that the task is about, as they stand in the file: from them one can
// tell which of the tasks of a file was changed. In a folder of tasks they are in a file next to the
// task's, with this ending.
inline constexpr const char* kFunctions = ".functions";
std::string functions_of(const Clone& clone, const Texts& texts, const std::string& slug);

}  // namespace grader::door
