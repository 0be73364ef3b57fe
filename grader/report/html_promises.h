#pragma once

#include "grader/results/results.h"

#include <kainjow/mustache.hpp>

namespace grader::report {

// Returns whether a promise of the task leads: it fails at an input, which is in sight, with the commands that show it again.
bool has_leading_promise(const results::TaskResult& task);

// Sets the promises of a task for the template: those that are not kept, the most telling in sight and the others folded, and those
// that are.
void set_promises(kainjow::mustache::data& out, const results::TaskResult& task);

}  // namespace grader::report
