#pragma once

#include "grader/service/process/process_time.h"

#include <chrono>
#include <optional>

namespace grader::process {

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
