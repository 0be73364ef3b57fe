#pragma once

#include <chrono>

#include <sched.h>
#include <sys/types.h>

namespace grader::process {

// Keeps this thread and another process on one processor while they exchange messages. One of the
// two always waits for the other, and waking a second, idle processor takes longer than most answers
// (measured in docs/decisions/0021-pictures.md).
//
// They change processors: after each kTurn, the kernel may place both for one exchange, so that two
// such pairs do not share a processor, or a pair does not stay on a busy one, while another is
// idle. Source: Linux, sched_setaffinity(2). Does nothing where the kernel does not allow it.
class OneProcessor {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kTurn{10};

  OneProcessor();
  ~OneProcessor() { let_go(); }
  OneProcessor(const OneProcessor&) = delete;
  OneProcessor& operator=(const OneProcessor&) = delete;

  // Call this before this thread sends `other` a message. `other` is a process with one thread; -1: it is not known yet.
  void hold(pid_t other);
  // Call this if the answer takes long: both may run anywhere until the next message.
  void let_go();

 private:
  void stay_on(pid_t other, const cpu_set_t& processors);

  cpu_set_t all_;         // all processors that this thread may use
  bool possible_ = true;  // false after the kernel refused
  pid_t held_ = -1;
  Clock::time_point since_;
};

}  // namespace grader::process
