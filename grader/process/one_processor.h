#pragma once

#include <chrono>

#include <sched.h>
#include <sys/types.h>

namespace grader::process {

// Keeps this thread and another process on one processor while they exchange messages. One of the
// two always waits for the other, and waking a second, idle processor takes longer than most answers
// (measured in docs/decisions/0021-pictures.md).
//
// No processor is theirs for long: after each kTurn, one exchange runs wherever the kernel puts it,
// so that two such pairs, or a busy processor, do not stay together while another one is idle.
// Source: Linux, sched_setaffinity(2). Does nothing where the kernel does not allow it.
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
  // The answer takes long: both may run where they like until the next message.
  void let_go();

 private:
  void stay_on(pid_t other, const cpu_set_t& processors);

  cpu_set_t all_;         // that this thread may use
  bool possible_ = true;  // until the kernel says no
  pid_t held_ = -1;
  Clock::time_point since_;
};

}  // namespace grader::process
