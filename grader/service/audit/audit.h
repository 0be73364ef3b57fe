#pragma once

#include "grader/service/audit/may_call.h"
#include "grader/tasks.h"

#include <set>
#include <string>
#include <string_view>

namespace grader::audit {

// The functions that one of our objects defines for others: for a reference, the functions of its
// contract. Throws pt::Error if it is not an object.
std::set<std::string> functions_in(std::string_view object);

// Returns one sentence on why an object of a submission is not linked; empty if it is linked. An
// object may define the functions of its contract, and inline functions and templates, which the
// linker merges. It may use the C++ standard library, C functions that compute or print, and the
// functions of pt that the task may call. It must not contain instructions to the linker. This
// check keeps the parts of a worker apart, and reports misplaced names and forbidden calls. The
// box, not this check, confines a worker.
std::string audit(std::string_view object, const std::set<std::string>& contract, const Task& task);

// Returns one sentence if code of the object runs before that of other objects, although it is linked after them; else empty.
std::string runs_early(std::string_view object);

}  // namespace grader::audit
