#include "grader/service/process/sleep_watch.h"

#include <algorithm>

namespace grader::process {

using std::chrono::nanoseconds;

nanoseconds SleepWatch::until_look() const {
  return std::max<nanoseconds>(kPause - waited_, nanoseconds(0));
}

void SleepWatch::look(pid_t pid) {
  doubtful_ += waited_;
  waited_ = nanoseconds(0);
  if (pid <= 0) return;
  const ProcessTime now = time_of_process(pid);
  if (!known_) {
    known_ = now;
    doubtful_ = nanoseconds(0);
    return;
  }
  if (!now.asleep) return;
  const nanoseconds slept =
      doubtful_ - (now.running - known_->running) - (now.waiting - known_->waiting);
  slept_ += std::max(slept, nanoseconds(0));
  known_ = now;
  doubtful_ = nanoseconds(0);
}

}  // namespace grader::process
