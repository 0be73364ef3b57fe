#include "grader/process/time_limit.h"

#include <algorithm>

namespace grader::process {

using std::chrono::nanoseconds;

TimeLimit::TimeLimit(pid_t pid, nanoseconds limit, nanoseconds running_before)
    : pid_(pid),
      limit_(limit),
      before_(running_before),
      start_(Clock::now()),
      next_look_(start_ + limit) {}

bool TimeLimit::is_over() {
  const ProcessTime time = time_of_tree(pid_);
  const nanoseconds left = limit_ - (time.running - before_);
  if (left <= nanoseconds(0) || Clock::now() - start_ > kForever * limit_) return true;
  if (!first_) {
    first_ = time;
    waited_ = nanoseconds(0);
  }
  // While it computes or waits for a processor, it does not sleep.
  const nanoseconds slept =
      waited_ - (time.running - first_->running) - (time.waiting - first_->waiting);
  if (slept > kPatience * limit_) return true;
  constexpr nanoseconds kSoonest = std::chrono::milliseconds(2);
  next_look_ = Clock::now() + std::clamp(left, kSoonest, std::max(kSoonest, limit_ / 2));
  return false;
}

nanoseconds Wait::net(nanoseconds longest) const {
  const nanoseconds whole = TimeLimit::Clock::now() - start_;
  return std::clamp(whole - (own_waiting_time() - own_waiting_), nanoseconds(0), longest);
}

}  // namespace grader::process
