#include "grader/process/time_limit.h"

#include <algorithm>

namespace grader {

using std::chrono::nanoseconds;

TimeLimit::TimeLimit(pid_t pid, nanoseconds limit, nanoseconds running_before)
    : pid_(pid), limit_(limit), before_(running_before), next_look_(Clock::now() + limit) {}

bool TimeLimit::is_over() {
  const ProcessTime time = time_of_tree(pid_);
  const nanoseconds own_waiting = own_waiting_time();
  const nanoseconds left = limit_ - (time.running - before_);
  if (left <= nanoseconds(0)) return true;
  if (!first_) {
    first_ = First{time, own_waiting};
    waited_ = nanoseconds(0);
  }
  // While it computes or waits for a processor, it does not sleep; nor may it be blamed if this
  // process had an answer and was not given a processor to read it.
  const nanoseconds slept = waited_ - (time.running - first_->process.running) -
                            (time.waiting - first_->process.waiting) -
                            (own_waiting - first_->own_waiting);
  if (slept > kPatience * limit_) return true;
  constexpr nanoseconds kSoonest = std::chrono::milliseconds(2);
  next_look_ = Clock::now() + std::clamp(left, kSoonest, std::max(kSoonest, limit_ / 2));
  return false;
}

}  // namespace grader
