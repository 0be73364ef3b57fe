#pragma once

#include "grader/process/process_time.h"

#include <optional>

namespace grader::process {

// The usual limit of one call of a task: a right one takes microseconds.
inline constexpr std::chrono::milliseconds kCallLimit{2000};

// A limit on the processor time of a process and its descendants, the same on a busy machine: time in
// which they wait for a processor does not count, nor does time in which this process computes. A
// process that sleeps instead of computing is ended too, after kPatience times the limit. If the
// machine is so busy that neither limit is reached, there is no verdict (expect_processor).
//
// The kernel is asked only when so much time has gone by that the limit may have been reached.
class TimeLimit {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr int kPatience = 4, kMaxByClock = 100;

  TimeLimit() = default;
  // From now on; `running_before` is what the processes ran until now.
  TimeLimit(pid_t pid, std::chrono::nanoseconds limit,
            std::chrono::nanoseconds running_before = std::chrono::nanoseconds(0));

  // The earliest time at which the limit can be reached.
  Clock::time_point next_look() const { return next_look_; }

  // Adds a time in which this process only waited for the other one (see Wait).
  void add_waited(std::chrono::nanoseconds time) { waited_ += time; }

  // Returns whether the kernel was asked already: then the call has lasted for some milliseconds.
  bool was_looked_at() const { return first_.has_value(); }

  // Asks the kernel, and puts off the next look. Throws pt::Error where the machine is too busy.
  bool is_over();

 private:
  pid_t pid_ = -1;
  std::chrono::nanoseconds limit_{0}, before_{0};
  std::chrono::nanoseconds waited_{0};  // since the first look
  std::optional<ProcessTime> first_;    // what was known then
  Clock::time_point start_, next_look_;
};

// Throws pt::Error, with advice, if a program has run longer than `most` by the clock; `running` is the processor time
// that it had: the machine is too busy for a verdict.
void expect_processor(std::chrono::nanoseconds running, std::chrono::nanoseconds by_the_clock,
                      std::chrono::nanoseconds most);

// One wait of this thread, from the constructor on. Takes some 20 microseconds.
class Wait {
 public:
  // The time that it lasted, minus the time in which this thread was ready but had no processor; `longest`
  // is what it was to last at most: a machine that stood still meanwhile makes it longer.
  std::chrono::nanoseconds net(std::chrono::nanoseconds longest) const;

 private:
  TimeLimit::Clock::time_point start_ = TimeLimit::Clock::now();
  std::chrono::nanoseconds own_waiting_ = own_waiting_time();
};

}  // namespace grader::process
