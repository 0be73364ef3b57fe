// The limits of all calls together: how much workers have used, and when calls end.
#include "grader/service/wire/session.h"
#include "pt/error.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace grader::wire {

namespace {

constexpr int kMaxAge = 20;  // by the clock, in limits of all calls
constexpr int kHung = 125;   // a hanging worker counts as this many failures

double seconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

// The cause is told once. For a smaller input it is not_attempted: the input is not kept, and no other
// one is tried (check::find_failure).
void Session::call_no_more(results::Cause cause, const std::string& why) {
  if (std::exchange(has_ended_, true)) cause = results::Cause::not_called;
  settings_.give_up(settings_.smaller_inputs ? results::Cause::not_attempted : cause,
                    "not called any more: " + why);
}

void Session::expect_time_left() {
  if (timeouts_ >= settings_.max_timeouts) {
    call_no_more(
        results::Cause::not_called,
        fmt::format("{} {} no answer", timeouts_, timeouts_ == 1 ? "call got" : "calls got"));
  }
  if (failures_ >= settings_.max_failures) {
    call_no_more(results::Cause::not_called, "too many calls crashed or gave no answer");
  }
  const std::uint64_t bytes = answered() - answered_before_;
  if (bytes > settings_.max_answered) {
    call_no_more(
        results::Cause::bad_reply,
        fmt::format("its results and its calls of other tasks were {} MiB in all, where {} "
                    "are the most",
                    bytes >> 20, settings_.max_answered >> 20));
  }
  expect_total_time_left();
}

// The time during which workers slept counts, since a task never has to wait. Waiting for a
// processor does not count; if it takes too long, there is no verdict.
void Session::expect_total_time_left() {
  const auto give_up = [&](std::chrono::nanoseconds took) {
    call_no_more(results::Cause::timeout,
                 fmt::format("all calls so far took {:.1f} s", seconds(took)));
  };
  const auto running = running_ + (worker_ ? worker_->running() : Clock::duration::zero());
  if (running > settings_.total_limit) give_up(running);
  const auto patience = settings_.total_limit / 2;
  const auto most = worker_ ? worker_->waited() - worker_->running() : Clock::duration::zero();
  if (slept_ + most > patience && slept() > patience) give_up(slept());
  try {
    process::expect_processor(running, Clock::now() - first_call_, kMaxAge * settings_.total_limit);
  } catch (const pt::Error& busy) {
    settings_.at_fault(busy.what());
  }
}

std::chrono::nanoseconds Session::slept() const {
  if (!worker_) return slept_;
  const auto slept = worker_->waited() - worker_->running() - worker_->starved();
  return slept_ + std::max<std::chrono::nanoseconds>(slept, Clock::duration::zero());
}

// The kernel does not report how long a dead process waited for a processor. So only the part of
// the judge's waiting time counts during which the process was seen asleep.
void Session::keep_totals(results::Cause cause) {
  slept_ = cause == results::Cause::timeout ? slept() : slept_ + worker_->slept();
  running_ += worker_->running();
  answered_ += worker_->answered();
}

void Session::count_failure(const WorkerFailed& failure) {
  if (failure.cause == results::Cause::timeout) {
    ++timeouts_;
  } else {
    failures_ += failure.hung ? kHung : 1;
  }
}

}  // namespace grader::wire
