#include "grader/service/process/one_processor.h"

namespace grader::process {

OneProcessor::OneProcessor() {
  possible_ = sched_getaffinity(0, sizeof all_, &all_) == 0 && CPU_COUNT(&all_) > 1;
}

void OneProcessor::hold(pid_t other) {
  if (!possible_ || other <= 0) return;
  const Clock::time_point now = Clock::now();
  if (held_ == other) {
    if (now - since_ > kTurn) let_go();
    return;
  }
  let_go();
  const int here = sched_getcpu();
  if (here < 0 || here >= CPU_SETSIZE) return;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(static_cast<std::size_t>(here), &one);
  held_ = other;
  since_ = now;
  stay_on(other, one);
}

void OneProcessor::let_go() {
  if (held_ <= 0) return;
  stay_on(held_, all_);
  held_ = -1;
}

// The other process comes first: if it has ended or is another user's, this thread stays free too.
void OneProcessor::stay_on(pid_t other, const cpu_set_t& processors) {
  possible_ = sched_setaffinity(other, sizeof processors, &processors) == 0;
  sched_setaffinity(0, sizeof processors, possible_ ? &processors : &all_);
}

}  // namespace grader::process
