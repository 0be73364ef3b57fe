#include "grader/service/process/time_limit.h"

#include "pt/error.h"

#include <algorithm>

#include <fmt/format.h>

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
  if (left <= nanoseconds(0)) return true;
  if (!first_) {
    first_ = time;
    waited_ = nanoseconds(0);
  }
  // While it computes or waits for a processor, it does not sleep.
  const nanoseconds slept =
      waited_ - (time.running - first_->running) - (time.waiting - first_->waiting);
  if (slept > kPatience * limit_) return true;
  expect_processor(time.running - before_, Clock::now() - start_, kMaxByClock * limit_);
  constexpr nanoseconds kSoonest = std::chrono::milliseconds(2);
  next_look_ = Clock::now() + std::clamp(left, kSoonest, std::max(kSoonest, limit_ / 2));
  return false;
}

void expect_processor(nanoseconds running, nanoseconds by_the_clock, nanoseconds most) {
  using Seconds = std::chrono::duration<double>;
  if (by_the_clock <= most) return;
  throw pt::Error(
      fmt::format("the machine is too busy: a program had {:.2f} s of processor time in {:.1f} s; "
                  "try again when less runs beside it",
                  Seconds(running).count(), Seconds(by_the_clock).count()));
}

nanoseconds Wait::net(nanoseconds longest) const {
  const nanoseconds whole = TimeLimit::Clock::now() - start_;
  return std::clamp(whole - (own_waiting_time() - own_waiting_), nanoseconds(0), longest);
}

}  // namespace grader::process
