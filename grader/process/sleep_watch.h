#pragma once

#include "grader/process/process_time.h"

#include <chrono>
#include <optional>

namespace grader::process {

// Measures how long a process sleeps while it lives: once it has ended, the kernel does not know any
// more how long it had waited for a processor. So the process that waits for it looks from time to time.
// Only certain sleep counts. A wait for a processor that is going on is not known yet, so no time is
// taken for sleep unless the process is seen asleep, and the time after the last look is left out.
class SleepWatch {
 public:
  // Looks are close together at first and then less, so that little of a sleep is missed.
  static constexpr std::chrono::milliseconds kFirst{10}, kLongest{40};

  // Adds a time in which this process only waited for the other one (see Wait).
  void add_waited(std::chrono::nanoseconds time) { waited_ += time; }

  // After so much more of it, look() is worth its cost.
  std::chrono::nanoseconds until_look() const;

  // Asks the kernel about the process; -1: it has not begun yet.
  void look(pid_t pid);

  std::chrono::nanoseconds slept() const { return slept_; }

 private:
  std::optional<ProcessTime> known_;        // when it was last certain
  std::chrono::nanoseconds waited_{0};      // since the last look
  std::chrono::nanoseconds doubtful_{0};    // before that, since known_
  std::chrono::nanoseconds usual_{kFirst};  // pause between looks
  std::chrono::nanoseconds pause_{kFirst};  // the next one
  std::chrono::nanoseconds slept_{0};
};

}  // namespace grader::process
