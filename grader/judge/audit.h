#pragma once

#include "grader/judge/may_call.h"
#include "grader/tasks.h"

#include <set>
#include <string>
#include <string_view>

namespace grader::judge {

// The functions that an object of ours defines for others: those of a contract, if it is the
// reference's. Throws pt::Error if it is not an object.
std::set<std::string> functions_in(std::string_view object);

// Returns in one sentence why an object of a submission is not linked; empty if it is. It may
// define the functions of its contract, and what the linker merges with the same in other objects
// (inline functions, templates); it may need the standard library of C++, functions of C that
// compute or print, and of pt what the task may call. Nothing in it may speak to the linker. This
// keeps the parts of a worker apart from each other, and tells a learner of a name in the wrong
// place, and of work that another function does; what holds a worker is the box.
std::string audit(std::string_view object, const std::set<std::string>& contract, const Task& task);

}  // namespace grader::judge
