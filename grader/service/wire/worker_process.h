#pragma once

#include "grader/base/descriptor.h"
#include "grader/results/results.h"
#include "grader/service/process/one_processor.h"
#include "grader/service/process/process_time.h"
#include "grader/service/process/time_limit.h"
#include "grader/service/sandbox/launcher_messages.h"
#include "grader/service/wire/message.h"
#include "pt/error.h"

#include <chrono>
#include <memory>
#include <string>
#include <thread>

// The judge's end: a worker as a process in its box.

namespace grader::wire {

using Clock = std::chrono::steady_clock;

// A failed conversation. The text tells a person what the worker did; it is empty if the limit of a call was reached.
struct WorkerFailed {
  results::Cause cause = results::Cause::crash;
  std::string text;
  bool alive = false;  // the worker may be called again
  bool hung = false;   // the judge waited, but it did not end by itself
};

// The worker could not be started. A submission cannot cause this.
struct WorkerNotStarted {
  std::string text;
};

struct Message {
  Kind kind = Kind::reply;
  std::string payload;
};

// A running worker. The constructor starts it, and the destructor ends it, whatever the worker does.
// Everything that it sends is checked before it is used. No wait is longer than a limit, and a limit
// counts what the worker computes, so that a verdict does not depend on the load of the machine.
class WorkerProcess {
 public:
  // Starts the program in a box of the tier.
  WorkerProcess(const std::string& program, sandbox::Tier tier, std::size_t max_printed);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  // From now on it may use this much time (grader/service/process/time_limit.h).
  void allow(std::chrono::milliseconds limit);
  // It may use this much more.
  void extend(std::chrono::nanoseconds by) { limit_.extend(by); }

  // Both throw WorkerFailed, or WorkerNotStarted.
  void send(Kind kind, std::uint64_t sequence, std::string_view payload);
  Message receive(std::uint64_t sequence);

  // The processor time that it had used at the last call of allow().
  std::chrono::nanoseconds running() const { return running_; }
  // The time during which this process only waited for it.
  std::chrono::nanoseconds waited() const { return waited_; }
  // The time that it surely slept; also after its end, when the kernel no longer knows it.
  std::chrono::nanoseconds slept() const { return sleep_.slept(); }
  // The time that it has waited for a processor so far. Calls the kernel, which takes a while.
  std::chrono::nanoseconds starved() const { return process::time_of_tree(pid_).waiting; }

  // The number of bytes in its answers, unfinished ones included.
  std::uint64_t answered() const { return answered_; }

  // The beginning of its output.
  const std::string& printed() const { return printed_; }

 private:
  // Waits until the descriptor is ready. Meanwhile it reads the worker's output.
  void wait(const base::Descriptor& descriptor, short event);
  void watch_sleep();
  void take_output();
  void fill(std::size_t size);  // until buffer_ has `size` bytes
  bool has_started() const;     // once the launcher has reported it
  [[noreturn]] void ended();

  pid_t pid_ = -1;                    // of the child: the program, or the box around it
  pid_t worker_ = -1;                 // the program, once it is known
  std::shared_ptr<const void> held_;  // see process::Child
  sandbox::Tier tier_;
  process::TimeLimit limit_;
  process::SleepWatch sleep_;
  process::OneProcessor together_;  // keeps this thread with the worker
  std::chrono::nanoseconds running_{0}, waited_{0};
  base::Descriptor to_worker_, from_worker_, output_;
  base::Descriptor launcher_;  // see Box::tells_start
  sandbox::LauncherMessages messages_;
  std::string buffer_;  // received and not yet used
  std::string printed_, last_words_;
  std::size_t max_printed_;
  std::size_t bytes_printed_ = 0;
  std::uint64_t answered_ = 0;
  bool has_answered_ = false;
};

// Starts a worker in its box. Throws WorkerNotStarted.
std::unique_ptr<WorkerProcess> start_worker(const std::string& program, sandbox::Tier tier,
                                            std::size_t max_printed);

// Returns the result of `converse()`, which starts a worker if there is none. If the worker cannot
// start, it tries again, four times in all: processes, memory or users may be short for a moment.
// Throws pt::Error if all attempts fail.
template <class Converse>
auto try_again(std::unique_ptr<WorkerProcess>& worker, const Converse& converse) {
  constexpr int kMaxStarts = 4;
  constexpr std::chrono::milliseconds kPause{200};
  for (int attempt = 1;; ++attempt) {
    try {
      return converse();
    } catch (const WorkerNotStarted& problem) {
      worker.reset();
      if (attempt == kMaxStarts) throw pt::Error("a worker cannot start: " + problem.text);
      std::this_thread::sleep_for(kPause * attempt);
    }
  }
}

}  // namespace grader::wire
