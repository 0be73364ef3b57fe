#pragma once

#include <cstdint>

// The worker's end: finds out whether a task keeps a variable between its calls: the renderer calls tasks from
// several threads at once, and such a variable would be shared by all of them. The judge has put
// the variables of a submission that live as long as the program, and may be written, into sections
// of their own (grader/judge/object_file.h). A byte that two calls have changed is kept state; one
// that a single call changes is a table that is filled at first use, a guard, or std::once_flag.
// Variables of a thread (thread_local) and constants are not in them.

namespace grader::wire {

// After a call: 1 + the place in the sections of the first byte that two calls have changed, itself
// or in memory that a pointer there leads to; 0 if there is none.
std::uint64_t kept_state();

}  // namespace grader::wire
