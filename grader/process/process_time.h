#pragma once

#include <chrono>

#include <sys/types.h>

// Measures how long processes ran and had to wait. A limit that counts what a process computed, and
// not what the clock says, is the same on a busy machine.

namespace grader::process {

struct ProcessTime {
  std::chrono::nanoseconds running{0};  // on a processor
  std::chrono::nanoseconds waiting{0};  // ready to run while no processor was given to it
  // It waited for something else than a processor when this was read, so that no wait for one was
  // going on, which `waiting` would not have known. Only of one process.
  bool asleep = false;
};

// The time of a process and its descendants since each began, those included that have ended and
// were waited for. `waiting` is up to date but for the wait that is just going on. Zero where the
// kernel does not tell, or there is no such process. Takes some milliseconds: all processes of the
// machine are looked at. Source: /proc/PID/stat and schedstat (Linux,
// Documentation/scheduler/sched-stats).
ProcessTime time_of_tree(pid_t pid);

// The time of one process alone, while it lives; takes some 30 microseconds.
ProcessTime time_of_process(pid_t pid);

// The processor time of one process; takes less than a microsecond.
std::chrono::nanoseconds running_time(pid_t pid);

// The time in which this thread was ready to run and had no processor.
std::chrono::nanoseconds own_waiting_time();

// The youngest of a process's descendants that has no children; the process itself if it has none.
pid_t last_descendant(pid_t pid);

}  // namespace grader::process
