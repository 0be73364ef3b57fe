#include "grader/process/sleep_watch.h"

#include <algorithm>

namespace grader::process {

using std::chrono::nanoseconds;

namespace {

// Half of it to one and a half: a program that knew when somebody looks would compute just then.
nanoseconds unforeseen(nanoseconds usual) {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return usual / 2 + nanoseconds(now.count() % usual.count());
}

}  // namespace

nanoseconds SleepWatch::until_look() const {
  return std::max<nanoseconds>(pause_ - waited_, nanoseconds(0));
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
  usual_ = std::min<nanoseconds>(2 * usual_, kLongest);
  pause_ = unforeseen(usual_);
  if (!now.asleep) return;
  const nanoseconds slept =
      doubtful_ - (now.running - known_->running) - (now.waiting - known_->waiting);
  slept_ += std::max(slept, nanoseconds(0));
  known_ = now;
  doubtful_ = nanoseconds(0);
}

}  // namespace grader::process
