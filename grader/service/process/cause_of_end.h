#pragma once

#include <csignal>
#include <string>

namespace grader::process {

// Ends a worker whose stack overflowed (grader/service/wire/worker_main.cpp). Every system has this signal, and nothing else sends it.
inline constexpr int kStackOverflow = SIGVTALRM;

// The reason why a worker ended, for a learner to read: "endless recursion: the stack overflowed".
// It comes from the status that waitpid gives, and from the last lines that the worker printed. A
// missing return gives SIGILL, because of the flags in grader/service/build/builder.cpp.
std::string cause_of_end(int status, const std::string& last_words);

// Returns whether a text of cause_of_end says that the process was killed from outside. A machine
// without memory does that, so the call is tried again before it counts.
bool was_killed(const std::string& cause);

}  // namespace grader::process
