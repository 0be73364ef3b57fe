#pragma once

#include "grader/door/texts.h"

#include <string>

namespace grader::door {

// Returns whether a function of the task is as it was handed out. `code` is the learner's file without
// comments.
bool is_unwritten(const Adapter& adapter, const std::string& code);

}  // namespace grader::door
