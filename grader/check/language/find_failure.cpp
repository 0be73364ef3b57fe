#include "grader/check/language/find_failure.h"

#include "grader/check/language/choices.h"
#include "grader/check/language/fail.h"

#include <algorithm>
#include <sstream>

#include <rapidcheck.h>
#include <rapidcheck/detail/TestListener.h>

namespace grader::check {

namespace {

using results::Cause;
using results::Failure;

// The largest number of smaller inputs to try; most failures need 20. It is no time, so that every
// machine shows the same input. For costly inputs, the session has a limit of its own.
constexpr int kMaxSmaller = 100;

// Before that, so many inputs of simple values, each of which may show the fault at once. A mean takes thousands of calls.
constexpr int kSimple = 40, kSimpleMeans = 8;

int searches_for_smaller = 0;
bool is_searching = false;

// Thrown to stop RapidCheck, which would continue a search for as long as it finds something.
struct Enough {};

// Returns how many smaller inputs to try after a failure. It is zero if a call hangs, because each
// input that hangs too costs the whole time limit.
int shrink_attempts(Cause cause, const FailureSearch& search) {
  if (!search.shrinks) return 0;
  switch (cause) {
    case Cause::wrong:
      return kMaxSmaller;
    case Cause::crash:
    case Cause::bad_reply:
      return search.max_crashes;
    case Cause::timeout:
    case Cause::not_attempted:
    case Cause::not_called:
      return 0;
  }
  return 0;
}

// A property whose runs are counted, so that one of them can be repeated. RapidCheck keeps only the
// text of a failure, so the failure itself is stored here.
struct Counted {
  const std::function<void()>& property;
  int stop_at = 0;  // the run before which a debugger stops; 0: none
  int runs = 0;
  std::optional<Failure> failure{};  // of the last run

  void run() {
    failure.reset();
    if (++runs == stop_at) at_smallest_failure();
    try {
      property();
    } catch (const CaseFailed& failed) {
      failure = failed.failure;
      throw rc::detail::CaseResult(rc::detail::CaseResult::Type::Failure, "");
    }
  }
};

// RapidCheck gives the type if the generator has no name. Names end in a colon (draw). A value of
// several lines, for example a sphere and a ray, becomes several inputs. A number or a flag without
// a name, and a value that cannot be shown (<???>), would tell nobody anything.
void add_input(Failure& failure, const std::string& name, const std::string& value) {
  const bool has_name = name.ends_with(':');
  if (!has_name && value.find_first_of(" (") == value.npos) return;
  std::istringstream lines(value);
  for (std::string line; std::getline(lines, line);) {
    if (has_name) line.insert(0, name + " ");
    failure.input.push_back(line);
  }
}

rc::detail::TestParams params_of(std::uint64_t seed, int cases) {
  rc::detail::TestParams params;
  params.seed = seed;
  params.maxSuccess = cases;
  return params;
}

// Watches a search. After a failure it tries simple inputs, goes on from one that fails for the same cause or else from the failing
// one to smaller ones, keeps the smallest, and ends after a number of tries. (RapidCheck's own listener reads its
// configuration from the environment and prints it.)
class Watcher : public rc::detail::TestListener {
 public:
  Watcher(Counted& counted, const FailureSearch& search) : counted_(counted), search_(search) {}

  // Returns RapidCheck's message if the property failed and nothing ended the search.
  std::string check(const rc::detail::TestParams& params) {
    std::ostringstream text;
    try {
      const auto result =
          rc::detail::checkProperty(rc::detail::toProperty([this] { counted_.run(); }),
                                    rc::detail::TestMetadata{}, params, *this, {});
      if (!result.is<rc::detail::SuccessResult>()) rc::detail::printResultMessage(result, text);
    } catch (const Enough&) {
    }
    return text.str();
  }

  void onTestCaseFinished(const rc::detail::CaseDescription& tried) override {
    end_after_the_run_asked_for();
    if (is_searching) return see_simple(tried);
    if (tried.result.type == rc::detail::CaseResult::Type::Success) ++held_;
    if (tried.result.type != rc::detail::CaseResult::Type::Failure) return;
    keep(tried);
    ++searches_for_smaller;
    is_searching = true;
    cause_ = failure_.cause;
    attempts_left_ = shrink_attempts(cause_, search_);
    try_simple_inputs();
    if (attempts_left_ <= 0) throw Enough{};
  }

  void onShrinkTried(const rc::detail::CaseDescription& tried, bool fails) override {
    end_after_the_run_asked_for();
    if (fails) {
      // The verdict is that of the first failure.
      const Cause cause = counted_.failure ? counted_.failure->cause : Cause::wrong;
      if (cause == cause_) keep(tried);
      attempts_left_ = std::min(attempts_left_, shrink_attempts(cause, search_));
    }
    if (--attempts_left_ <= 0) throw Enough{};
  }

  void onTestFinished(const rc::detail::TestMetadata&, const rc::detail::TestResult&) override {}

  Found found() const {
    if (!smallest_) return {};
    Failure failure = failure_;
    failure.cases_before = held_;
    failure.simple = is_simple_;
    // RapidCheck makes the values once more.
    choose_simply(is_simple_);
    for (const auto& [name, value] : smallest_->example()) add_input(failure, name, value);
    choose_simply(false);
    return {failure, smallest_run_, ""};
  }

 private:
  // A search for simple inputs runs within the one that failed, which goes on if none of them fails.
  void try_simple_inputs() {
    const int most = failure_.statistical ? kSimpleMeans : kSimple;
    choose_simply(true);
    for (int i = 0; i < most && attempts_left_ > 1 && !is_simple_; ++i) {
      check(params_of(search_.seed + static_cast<std::uint64_t>(i), 1));
    }
    choose_simply(false);
    end_after_the_run_asked_for();
    if (is_simple_) throw Enough{};
  }

  void see_simple(const rc::detail::CaseDescription& tried) {
    if (tried.result.type != rc::detail::CaseResult::Type::Failure) throw Enough{};
    const Cause cause = counted_.failure ? counted_.failure->cause : Cause::wrong;
    attempts_left_ = std::min(attempts_left_, shrink_attempts(cause, search_)) - 1;
    if (cause != cause_ || attempts_left_ <= 0) throw Enough{};
    is_simple_ = true;
    keep(tried);
  }

  void end_after_the_run_asked_for() const {
    if (counted_.stop_at > 0 && counted_.runs >= counted_.stop_at) throw Enough{};
  }

  // If something else was thrown, the text of RapidCheck says what.
  void keep(const rc::detail::CaseDescription& tried) {
    smallest_ = tried;
    smallest_run_ = counted_.runs;
    failure_ = counted_.failure.value_or(Failure{.got = tried.result.description});
  }

  Counted& counted_;
  const FailureSearch& search_;
  std::optional<rc::detail::CaseDescription> smallest_;
  Failure failure_;  // of the smallest failing case
  int smallest_run_ = 0;
  int held_ = 0;
  int attempts_left_ = 0;
  bool is_simple_ = false;      // an input of simple values fails
  Cause cause_ = Cause::wrong;  // of the first failure
};

}  // namespace

Found find_failure(const std::function<void()>& property, const FailureSearch& search) {
  Counted counted{property};
  Watcher watcher(counted, search);
  const std::string fault = watcher.check(params_of(search.seed, search.cases));
  is_searching = false;
  Found found = watcher.found();
  if (!found.failure) found.fault = fault;
  return found;
}

int search_for_smaller() { return is_searching ? searches_for_smaller : 0; }

void run_again(const std::function<void()>& property, const FailureSearch& search, int run) {
  Counted counted{property, run};
  Watcher(counted, search).check(params_of(search.seed, search.cases));
  is_searching = false;
}

void at_smallest_failure() { asm volatile(""); }

}  // namespace grader::check
