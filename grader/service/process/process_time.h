#pragma once

#include <chrono>
#include <optional>

#include <sys/types.h>

// Measures how long processes ran and had to wait. A limit on processor time, unlike a limit by the
// clock, is the same on a busy machine.

namespace grader::process {

struct ProcessTime {
  std::chrono::nanoseconds running{0};  // on a processor
  std::chrono::nanoseconds waiting{0};  // ready to run while no processor was given to it
  // It slept when this was read and did not wait for a processor, so `waiting` is complete. Only
  // time_of_process sets this.
  bool asleep = false;
};

// The time of a process and its descendants since each began, including descendants that have ended
// and were waited for. `waiting` lacks the current wait. Zero if the kernel does not report it, or
// if there is no such process. Takes some milliseconds, because it reads all processes of the
// machine. Source: /proc/PID/stat and schedstat (Linux, Documentation/scheduler/sched-stats).
ProcessTime time_of_tree(pid_t pid);

// The time of one process alone, while it lives; takes some 30 microseconds.
ProcessTime time_of_process(pid_t pid);

// The processor time of one process; takes less than a microsecond.
std::chrono::nanoseconds running_time(pid_t pid);

// The time during which this thread was ready to run but had no processor.
std::chrono::nanoseconds own_waiting_time();

// The deepest descendant of the process: the last one in the order of /proc if there are several;
// the process itself if it has none.
pid_t last_descendant(pid_t pid);

// Measures how long a process sleeps. Once it has ended, the kernel no longer knows how long it had
// waited for a processor, so the process that waits for it looks from time to time. Only certain
// sleep counts: a current wait for a processor is not reported yet, so time counts as sleep only if
// the process is seen asleep, and the time after the last look is left out.
class SleepWatch {
 public:
  // The time between looks, short enough to miss little of a sleep.
  static constexpr std::chrono::milliseconds kPause{20};

  // Adds a time in which this process only waited for the other one (see Wait).
  void add_waited(std::chrono::nanoseconds time) { waited_ += time; }

  // The additional time after which look() is worth its cost.
  std::chrono::nanoseconds until_look() const;

  // Reads the process's time from the kernel; -1: it has not begun yet.
  void look(pid_t pid);

  std::chrono::nanoseconds slept() const { return slept_; }

 private:
  std::optional<ProcessTime> known_;      // at the last certain reading
  std::chrono::nanoseconds waited_{0};    // since the last look
  std::chrono::nanoseconds doubtful_{0};  // between known_ and the last look
  std::chrono::nanoseconds slept_{0};
};

}  // namespace grader::process
