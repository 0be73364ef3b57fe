#pragma once

#include "grader/process/process_time.h"

#include <optional>

namespace grader::process {

// The usual limit of one call of a task: a right one takes microseconds.
inline constexpr std::chrono::milliseconds kCallLimit{2000};

// A limit on the time that a process and its descendants may take, whatever else the machine does:
// so much of processor time. Time spent waiting for a processor does not count, nor does time in
// which this process computes. A process that sleeps instead of computing ends too, after kPatience times
// the limit. Where the machine is so busy that neither comes to an end, nobody can say how long the
// program takes: that is no verdict (expect_processor).
//
// The kernel is asked only when so much time has gone by that the limit may have been reached.
class TimeLimit {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr int kPatience = 4, kForever = 100;

  TimeLimit() = default;
  // From now on; `running_before` is what the processes ran until now.
  TimeLimit(pid_t pid, std::chrono::nanoseconds limit,
            std::chrono::nanoseconds running_before = std::chrono::nanoseconds(0));

  // The earliest time at which the limit can be reached.
  Clock::time_point next_look() const { return next_look_; }

  // This process did nothing for so long but wait for the other one (see Wait).
  void add_waited(std::chrono::nanoseconds time) { waited_ += time; }

  // Returns whether the kernel was asked already: then the call takes more than some milliseconds.
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

// Throws pt::Error, with what to do about it, if a program that has run for so long was not ended by its limits within
// `most`, by the clock: it waits for a processor.
void expect_processor(std::chrono::nanoseconds running, std::chrono::nanoseconds by_the_clock,
                      std::chrono::nanoseconds most);

// One wait of this thread, from the constructor on. Takes some 20 microseconds.
class Wait {
 public:
  // How long it lasted, minus the time in which this thread was ready but had no processor; `longest`
  // is what it was to last at most: a machine that stood still meanwhile makes it longer.
  std::chrono::nanoseconds net(std::chrono::nanoseconds longest) const;

 private:
  TimeLimit::Clock::time_point start_ = TimeLimit::Clock::now();
  std::chrono::nanoseconds own_waiting_ = own_waiting_time();
};

}  // namespace grader::process
