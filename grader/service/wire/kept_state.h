#pragma once

#include <cstdint>
#include <limits>

// The worker's end: finds out whether a task keeps state between calls. The renderer calls tasks
// from several threads at once, which would share it. The judge has moved the writable static
// variables of a submission to sections of their own (grader/service/audit/object_file.h). A byte
// that two calls have changed is kept state. A byte that one call changes may be a table that is
// filled at first use, a guard, or std::once_flag. Thread-local variables and constants are not in
// these sections.

namespace grader::wire {

// Call it after each call. Returns 1 + the place in the sections of the first byte that two calls
// have changed, directly or in memory that it points to; 0 if there is none.
std::uint64_t kept_state();

// In place of a place: a call has changed how the processor rounds, or what it does with tiny numbers, and has not changed it back.
inline constexpr std::uint64_t kProcessorMode = std::numeric_limits<std::uint64_t>::max();

// In place of a place: one of the first calls of the run, made again at its end, has another answer.
inline constexpr std::uint64_t kOtherAnswer = kProcessorMode - 1;

// That mode. The flags of what has happened are not in it.
unsigned processor_mode();

}  // namespace grader::wire
