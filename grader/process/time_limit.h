#pragma once

#include "grader/process/process_time.h"

#include <optional>

namespace grader {

// A limit on the time that a process and its descendants may take, whatever else the machine does:
// so much of processor time. Neither what it waits for a processor counts nor what this process
// computes meanwhile. A process that sleeps instead of computing ends too, after kPatience times
// the limit.
//
// The kernel is asked only when so much time has gone by that the limit may have been reached.
class TimeLimit {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr int kPatience = 4;

  TimeLimit() = default;
  // From now on; `running_before` is what the processes ran until now.
  TimeLimit(pid_t pid, std::chrono::nanoseconds limit,
            std::chrono::nanoseconds running_before = std::chrono::nanoseconds(0));

  // When it is worth asking whether it is over.
  Clock::time_point next_look() const { return next_look_; }

  // This process did nothing for so long but wait for the other one.
  void add_waited(std::chrono::nanoseconds time) { waited_ += time; }

  // Asks the kernel, and puts off the next look.
  bool is_over();

 private:
  // What was known at the first look.
  struct First {
    ProcessTime process;
    std::chrono::nanoseconds own_waiting;
  };

  pid_t pid_ = -1;
  std::chrono::nanoseconds limit_{0}, before_{0};
  std::chrono::nanoseconds waited_{0};  // since the first look
  std::optional<First> first_;
  Clock::time_point next_look_;
};

}  // namespace grader
