#pragma once

#include <string>

namespace grader::process {

// The reason why a worker ended, for a learner to read: "endless recursion: the stack overflowed".
// From its status, as waitpid gives it, and the last lines that it printed. A stack that overflows
// sends SIGSTKFLT (grader/wire/crash.h), and a function that ends without a return SIGILL (how
// submissions are compiled: grader/judge/builder.cpp).
std::string cause_of_end(int status, const std::string& last_words);

// Returns whether a text of cause_of_end says that the process was killed from outside. A machine
// without memory does that, so it is tried again before it counts.
bool was_killed(const std::string& cause);

}  // namespace grader::process
