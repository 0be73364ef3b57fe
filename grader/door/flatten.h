#pragma once

#include "grader/door/clone.h"
#include "grader/door/texts.h"

#include <string>

namespace grader::door {

// One file with all that the task needs: the learner's own source and headers, with #line, so that
// messages name the learner's file and line, between the adapter's parts. If the function is not
// written yet, the task says so.
std::string flatten(const Clone& clone, const Texts& texts, const std::string& slug);

}  // namespace grader::door
