#pragma once

#include <chrono>

#include <sys/types.h>

namespace grader {

// How long a process and its descendants, since each began, were ready to run while no processor
// was given to them. A limit of time that leaves this out is the same on a busy machine. Up to date
// but for the wait that is just going on; zero where the kernel does not tell, or the process has
// ended. Source: /proc/PID/schedstat (Linux, Documentation/scheduler/sched-stats).
std::chrono::nanoseconds starved(pid_t pid);

}  // namespace grader
