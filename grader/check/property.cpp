#include "grader/check/property.h"

#include "grader/check/fail.h"
#include "grader/check/replay.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <sstream>

#include <fmt/format.h>

namespace grader::check {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kShrinkTime{500};

bool is_shrinking = true;

std::vector<Failure>& mutable_failures() {
  static std::vector<Failure> all;
  return all;
}

// A case fails by an exception whose text is one of these lines a field; RapidCheck keeps the text
// of the smallest failing case.
constexpr std::string_view kFields[] = {"what: ", "got: ", "expected: ", "off by: "};

constexpr std::array kCauses{Cause::wrong, Cause::crash, Cause::timeout, Cause::bad_reply,
                             Cause::not_attempted};
constexpr std::string_view kCauseField = "cause: ";

// How many smaller inputs to try after a failure: a call that died costs a new process, one that
// hangs the whole limit.
int shrink_attempts(Cause cause) {
  if (!is_shrinking) return 0;
  switch (cause) {
    case Cause::wrong:
      return std::numeric_limits<int>::max();
    case Cause::crash:
    case Cause::bad_reply:
      return 20;
    case Cause::timeout:
      return 1;
    case Cause::not_attempted:
      return 0;
  }
  return 0;
}

// Labels stand at the start of a line: what a submission wrote never does.
std::string field(const std::string& text, std::string_view label) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(label)) return line.substr(label.size());
  }
  return "";
}

std::uint64_t hash(std::string_view text, std::uint64_t start) {
  std::uint64_t h = 0xcbf29ce484222325 ^ (start * 0x9e3779b97f4a7c15);  // FNV-1a
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return h;
}

Cause cause_of(const std::string& text) {
  const std::string cause = field(text, kCauseField);
  for (const Cause known : kCauses) {
    if (cause == name(known)) return known;
  }
  return Cause::wrong;
}

// Follows a property: keeps the smallest failing case, and ends the search for a smaller one after
// a while. (RapidCheck's own listener reads its configuration from the environment and prints it.)
class Watcher : public rc::detail::TestListener {
 public:
  explicit Watcher(const Counted& counted) : counted_(counted) {}

  void onTestCaseFinished(const rc::detail::CaseDescription& tried) override {
    if (tried.result.type == rc::detail::CaseResult::Type::Success) ++held_;
    if (tried.result.type != rc::detail::CaseResult::Type::Failure) return;
    keep(tried);
    deadline_ = Clock::now() + kShrinkTime;
    cause_ = cause_of(tried.result.description);
    attempts_left_ = shrink_attempts(cause_);
    if (attempts_left_ == 0) throw Enough{};
  }

  void onShrinkTried(const rc::detail::CaseDescription& tried, bool fails) override {
    if (fails) {
      // How far the search gets depends on the machine; the cause, and so the verdict, must not.
      const Cause cause = cause_of(tried.result.description);
      if (cause == cause_) keep(tried);
      attempts_left_ = std::min(attempts_left_, shrink_attempts(cause));
    }
    if (--attempts_left_ <= 0 || Clock::now() > deadline_) throw Enough{};
  }

  void onTestFinished(const rc::detail::TestMetadata&, const rc::detail::TestResult&) override {}

  const std::optional<rc::detail::CaseDescription>& smallest() const { return smallest_; }
  int held() const { return held_; }
  int smallest_run() const { return smallest_run_; }

 private:
  void keep(const rc::detail::CaseDescription& tried) {
    smallest_ = tried;
    smallest_run_ = counted_.runs;
  }

  const Counted& counted_;
  int smallest_run_ = 0;
  std::optional<rc::detail::CaseDescription> smallest_;
  int held_ = 0;
  int attempts_left_ = 0;
  Cause cause_ = Cause::wrong;  // of the first failure
  Clock::time_point deadline_;
};

// What RapidCheck has to say if the property failed and the listener did not end it.
std::string check(Counted& counted, const rc::detail::TestParams& params,
                  rc::detail::TestListener& listener) {
  std::ostringstream text;
  try {
    const auto result = rc::detail::checkProperty(rc::detail::toProperty([&] { counted.run(); }),
                                                  rc::detail::TestMetadata{}, params, listener, {});
    if (!result.is<rc::detail::SuccessResult>()) rc::detail::printResultMessage(result, text);
  } catch (const Enough&) {
  }
  return text.str();
}

// RapidCheck gives the type where the generator has no name; names end in a colon (draw). A value
// of several lines, such as a sphere and a ray, is several inputs.
void add_input(Failure& failure, const std::string& name, const std::string& value) {
  std::istringstream lines(value);
  for (std::string line; std::getline(lines, line);) {
    if (name.ends_with(':')) line.insert(0, name + " ");
    failure.input.push_back(line);
  }
}

Failure describe(const rc::detail::CaseDescription& failed, int held) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string& text = failed.result.description;
  Failure failure{test->test_suite_name(), test->name(), {}, "", "", "", "", held, seed(),
                  cause_of(text)};
  for (const auto& [name, value] : failed.example()) add_input(failure, name, value);
  failure.what = field(text, kFields[0]);
  failure.got = field(text, kFields[1]);
  failure.expected = field(text, kFields[2]);
  failure.off_by = field(text, kFields[3]);
  if (failure.what.empty() && failure.got.empty()) failure.got = text;
  return failure;
}

std::string print(const Failure& failure) {
  std::string text = fmt::format("input (after {} cases that held, seed {}):\n",
                                 failure.cases_before, failure.seed);
  for (const std::string& line : failure.input) text += "  " + line + "\n";
  if (!failure.what.empty()) text += failure.what + "\n";
  text += fmt::format("  got      {}\n  expected {}\n", failure.got, failure.expected);
  if (!failure.off_by.empty()) text += fmt::format("  off by   {}\n", failure.off_by);
  return text;
}

// Without the digits far below `step`, but five at least.
std::string rounded_for_people(double value, double step) {
  const double digits = std::ceil(std::log10(std::abs(value) / step)) + 1;
  if (!(digits < 17)) return fmt::format("{}", value);
  return fmt::format("{:.{}g}", value, static_cast<int>(std::max(digits, 5.0)));
}

}  // namespace

std::uint64_t seed() {
  const char* text = std::getenv("FIRSTLIGHT_SEED");
  return text == nullptr ? 1 : std::strtoull(text, nullptr, 10);
}

void never_shrink() { is_shrinking = false; }

const std::vector<Failure>& failures() { return mutable_failures(); }

void for_all(const std::function<void()>& property, int cases) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  rc::detail::TestParams params;
  params.seed = hash(std::string(test->test_suite_name()) + "." + test->name(), seed());
  params.maxSuccess = cases;

  Counted counted{property};
  Watcher watcher(counted);
  const std::string fault = check(counted, params, watcher);
  if (watcher.smallest()) {
    mutable_failures().push_back(describe(*watcher.smallest(), watcher.held()));
    ADD_FAILURE() << print(mutable_failures().back());
    if (std::getenv("FIRSTLIGHT_REPLAY") != nullptr) {
      Counted again{property, watcher.smallest_run()};
      Replayer replayer(again);
      check(again, params, replayer);
    }
  } else if (!fault.empty()) {
    ADD_FAILURE() << "the property itself is at fault: " << fault;
  }
}

void fail_call(Cause cause, const std::string& got) {
  throw rc::detail::CaseResult(
      rc::detail::CaseResult::Type::Failure,
      fmt::format("what: \ngot: {}\nexpected: an answer\n{}{}\n", got, kCauseField, name(cause)));
}

void fail(const std::string& what, const std::string& got, const std::string& expected,
          const std::string& off_by) {
  throw rc::detail::CaseResult(
      rc::detail::CaseResult::Type::Failure,
      fmt::format("what: {}\ngot: {}\nexpected: {}\noff by: {}\n", what, got, expected, off_by));
}

void expect(bool condition, const std::string& expected, const std::string& got) {
  if (!condition) fail("", got, expected);
}

void expect_near(const std::string& what, double got, double expected, double tolerance) {
  const double off = std::abs(got - expected);
  if (!(off <= tolerance)) {
    const double step = std::max(tolerance, 1e-2 * off);
    fail(what, rounded_for_people(got, step),
         fmt::format("{}, give or take {:.2g}", rounded_for_people(expected, step), tolerance),
         fmt::format("{:.3g}", off));
  }
}

void expect_near(const std::string& what, pt::Vec3 got, pt::Vec3 expected, double tolerance) {
  const double off = length(got - expected);
  if (!(off <= tolerance)) {
    fail(what, show(got), fmt::format("{}, give or take {:.2g}", show(expected), tolerance),
         fmt::format("{:.3g}", off));
  }
}

void expect_near(const std::string& what, pt::Rgb got, pt::Rgb expected, double tolerance) {
  const pt::Rgb d = got - expected;
  const double off = std::sqrt(d.r * d.r + d.g * d.g + d.b * d.b);
  if (!(off <= tolerance)) {
    fail(what, show(got), fmt::format("{}, give or take {:.2g}", show(expected), tolerance),
         fmt::format("{:.3g}", off));
  }
}

void expect_equal(const std::string& what, long long got, long long expected) {
  if (got != expected) {
    fail(what, fmt::format("{}", got), fmt::format("{}", expected),
         fmt::format("{}", got - expected));
  }
}

}  // namespace grader::check
