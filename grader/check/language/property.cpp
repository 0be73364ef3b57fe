#include "grader/check/language/property.h"

#include "grader/check/language/choices.h"
#include "grader/check/language/fail.h"
#include "grader/check/language/find_failure.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string_view>

#include <fmt/format.h>

namespace grader::check {

namespace {

using results::Cause;
using results::Failure;

bool is_shrinking = true;

std::vector<FailedPromise>& mutable_failures() {
  static std::vector<FailedPromise> all;
  return all;
}

std::map<std::string, int>& mutable_checks() {
  static std::map<std::string, int> all;
  return all;
}

std::uint64_t hash(std::string_view text, std::uint64_t start) {
  std::uint64_t h = 0xcbf29ce484222325 ^ (start * 0x9e3779b97f4a7c15);  // FNV-1a
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return h;
}

bool crashed(const FailedPromise& promise) { return promise.failure.cause == Cause::crash; }

std::string print(const Failure& failure) {
  std::string text = fmt::format("input (after {} cases without a failure, seed {}):\n",
                                 failure.cases_before, failure.seed);
  for (const std::string& line : failure.input) text += "  " + line + "\n";
  if (!failure.what.empty()) text += failure.what + "\n";
  text += fmt::format("  got      {}\n  expected {}\n", failure.got, failure.expected);
  if (!failure.off_by.empty()) text += fmt::format("  off by   {}\n", failure.off_by);
  return text;
}

// Writes the value without the digits far below `step`, but with at least five digits.
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

const std::vector<FailedPromise>& failures() { return mutable_failures(); }

int checks_of(const std::string& promise) {
  const auto found = mutable_checks().find(promise);
  return found == mutable_checks().end() ? 0 : found->second;
}

void for_all(const std::function<void()>& property, int cases) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string task = test->test_suite_name(), promise = test->name();
  // Each call draws other inputs, also if its generators are those of the call before.
  const auto call = static_cast<std::uint64_t>(mutable_checks()[promise]++);
  FailureSearch search{hash(task + "." + promise, seed()) + call, cases, is_shrinking};
  choose_simply(std::getenv("FIRSTLIGHT_SIMPLE") != nullptr);
  // A task that crashes in one promise crashes in most promises, and one small input is enough.
  if (std::ranges::any_of(failures(), crashed)) search.max_crashes = 4;
  Found found = find_failure(property, search);
  if (found.failure) {
    found.failure->seed = seed();
    mutable_failures().push_back({task, promise, *found.failure});
    ADD_FAILURE() << print(*found.failure);
    if (std::getenv("FIRSTLIGHT_REPLAY") != nullptr) run_again(property, search, found.run);
  } else if (!found.fault.empty()) {
    ADD_FAILURE() << "the property itself is at fault: " << found.fault;
  }
}

void once(const std::function<void()>& property) {
  const std::size_t before = failures().size();
  for_all(property, 1);
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  if (failures().size() == before) --mutable_checks()[test->name()];
}

void fail_call(Cause cause, const std::string& got) {
  throw CaseFailed{{.got = got, .expected = "an answer", .cause = cause}};
}

void fail(const std::string& what, const std::string& got, const std::string& expected,
          const std::string& off_by) {
  throw CaseFailed{{.what = what, .got = got, .expected = expected, .off_by = off_by}};
}

void fail_statistical(const std::string& what, const std::string& got, const std::string& expected,
                      const std::string& off_by) {
  throw CaseFailed{
      {.what = what, .got = got, .expected = expected, .off_by = off_by, .statistical = true}};
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
    int worst = 0;
    for (const int channel : {1, 2}) {
      if (std::abs(d[channel]) > std::abs(d[worst])) worst = channel;
    }
    fail(what, show(got), fmt::format("{}, give or take {:.2g}", show(expected), tolerance),
         off_by(got[worst], expected[worst]));
  }
}

std::string off_by(double got, double expected) {
  const double off = std::abs(got - expected), ratio = got / expected;
  return std::isfinite(ratio) ? fmt::format("{:.3g} ({:.4g} times the expected value)", off, ratio)
                              : fmt::format("{:.3g}", off);
}

void expect_equal(const std::string& what, long long got, long long expected) {
  if (got != expected) {
    fail(what, fmt::format("{}", got), fmt::format("{}", expected),
         fmt::format("{}", got - expected));
  }
}

}  // namespace grader::check
