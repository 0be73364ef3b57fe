#pragma once

#include "grader/service/process/process_time.h"

#include <optional>

namespace grader::process {

// The usual limit of one call of a task. A right task takes microseconds.
inline constexpr std::chrono::milliseconds kCallLimit{2000};

// A limit on the processor time of a process and its descendants. It is the same on a busy machine:
// time during which they wait for a processor, or this process computes, does not count. A process
// that sleeps instead of computing is ended too, after kPatience times the limit. If the machine is
// so busy that neither limit is reached, there is no verdict (expect_processor).
//
// The kernel is only called when enough time has passed to reach the limit.
class TimeLimit {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr int kPatience = 4, kMaxByClock = 100;

  TimeLimit() = default;
  // Counts from now on; `running_before` is the processor time until now.
  TimeLimit(pid_t pid, std::chrono::nanoseconds limit,
            std::chrono::nanoseconds running_before = std::chrono::nanoseconds(0));

  // The earliest time at which the limit can be reached.
  Clock::time_point next_look() const { return next_look_; }

  // Allows more time.
  void extend(std::chrono::nanoseconds by) { limit_ += by; }

  // Adds a time in which this process only waited for the other one (see Wait).
  void add_waited(std::chrono::nanoseconds time) { waited_ += time; }

  // Returns whether the kernel was called already: then the call has lasted some milliseconds.
  bool was_looked_at() const { return first_.has_value(); }

  // Calls the kernel, and puts off the next call. Throws pt::Error if the machine is too busy.
  bool is_over();

 private:
  pid_t pid_ = -1;
  std::chrono::nanoseconds limit_{0}, before_{0};
  std::chrono::nanoseconds waited_{0};  // since the first look
  std::optional<ProcessTime> first_;    // the reading at the first look
  Clock::time_point start_, next_look_;
};

// Throws pt::Error, with advice, if a program has run longer than `most` by the clock: then the
// machine is too busy for a verdict. `running` is the program's processor time.
void expect_processor(std::chrono::nanoseconds running, std::chrono::nanoseconds by_the_clock,
                      std::chrono::nanoseconds most);

// One wait of this thread, from the constructor on. Takes some 20 microseconds.
class Wait {
 public:
  // Returns how long it lasted, without the time during which this thread was ready but had no
  // processor. `longest` is the requested maximum; the wait is longer if the machine stood still.
  std::chrono::nanoseconds net(std::chrono::nanoseconds longest) const;

 private:
  TimeLimit::Clock::time_point start_ = TimeLimit::Clock::now();
  std::chrono::nanoseconds own_waiting_ = own_waiting_time();
};

}  // namespace grader::process
