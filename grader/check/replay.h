#pragma once

#include <functional>

#include <rapidcheck.h>
#include <rapidcheck/detail/TestListener.h>

// The smallest failing case of a property, found again for a debugger.

namespace grader::check {

// The place where a debugger stops (./run debug): with FIRSTLIGHT_REPLAY set, the smallest failing
// case of each property runs once more, and this is called just before.
[[gnu::noinline]] inline void at_smallest_failure() { asm volatile(""); }

// Counts the runs of a property, so that one of them can be found again.
struct Counted {
  const std::function<void()>& property;
  int stop_at = 0;  // the run before which a debugger stops; 0: none
  int runs = 0;

  void run() {
    if (++runs == stop_at) at_smallest_failure();
    property();
  }
};

// Thrown to end what RapidCheck does: it would go on with a search for as long as it finds
// something.
struct Enough {};

// Ends a replay after the run that it is about.
class Replayer : public rc::detail::TestListener {
 public:
  explicit Replayer(const Counted& counted) : counted_(counted) {}

  void onTestCaseFinished(const rc::detail::CaseDescription&) override { stop(); }
  void onShrinkTried(const rc::detail::CaseDescription&, bool) override { stop(); }
  void onTestFinished(const rc::detail::TestMetadata&, const rc::detail::TestResult&) override {}

 private:
  void stop() const {
    if (counted_.runs >= counted_.stop_at) throw Enough{};
  }

  const Counted& counted_;
};

}  // namespace grader::check
