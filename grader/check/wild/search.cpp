#include "grader/check/wild/search.h"

#include "grader/check/language/fail.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace grader::check {

using explain::Explanation;
using explain::Fault;
using pt::Rgb;

namespace {

bool makes_wild_calls = true;

constexpr int kMaxMeans = 25;  // of wrong values: inputs that are judged by many calls
constexpr int kMaxSmallerCalls =
    300;  // inputs that are tried in place of one that fails; fewer of long calls

// An input whose calls take so many samples is asked for one call.
constexpr int kLong = 1000;

// Wrong values of a plain file are judged in pairs: the result, and what the record of the same call amounts to.
constexpr int kPairs = 3000, kPairedSamples = 30'000;
constexpr int kFewestOff = 10;

// A value that is off by less than this part of it is a question of precision, which other inputs ask.
constexpr double kPrecision = 1e-4;

// Returns whether the mean of the differences is more than chance makes of it.
bool is_biased(const Explanations& calls) {
  Rgb sum, squares, values;
  int off = 0;
  for (const Explanation& call : calls) {
    if (call.fault != Fault::value) continue;
    if (!is_finite(call.off)) return true;
    ++off;
    sum += call.off;
    squares += call.off * call.off;
    values += call.value;
  }
  if (off < kFewestOff) return false;
  const auto n = static_cast<double>(calls.size());
  for (int channel = 0; channel < 3; ++channel) {
    const double mean = sum[channel] / n;
    const double variance = std::max(0.0, squares[channel] / n - mean * mean);
    const double slack = kPrecision * std::abs(values[channel]) / n;
    if (std::abs(mean) > kStandardErrors * std::sqrt(variance / n) + slack) return true;
  }
  return false;
}

// Judges an input, and keeps the budget of those for which many calls are needed.
class Judge {
 public:
  Judge(int calls, bool keeps_habit, Plainness& seen)
      : calls_(calls), keeps_habit_(keeps_habit), seen_(seen) {}

  std::optional<Explanation> fault_of(const WildInput& input, std::uint64_t seed) {
    std::optional<Explanation> wrong_value;
    const int calls = input.samples() > kLong ? 1 : calls_;
    for (const Explanation& call : input.ask(calls, seed)) {
      seen_.add(call);
      if (call.fault == Fault::structure) return call;
      if (call.fault == Fault::habit && keeps_habit_) return call;
      if (call.fault == Fault::value && !wrong_value) wrong_value = call;
    }
    if (!wrong_value || means_ == kMaxMeans) return std::nullopt;
    ++means_;
    const int n = std::clamp(kPairedSamples / std::max(1, input.samples()), 100, kPairs);
    if (is_biased(input.ask(n, seed))) return wrong_value;
    return std::nullopt;
  }

 private:
  int calls_;  // of each input
  bool keeps_habit_;
  Plainness& seen_;
  int means_ = 0;
};

void make_smaller(Judge& judge, WildFailure& failure) {
  int left = kMaxSmallerCalls;
  for (bool goes_on = true; goes_on && left > 0;) {
    goes_on = false;
    for (const WildPointer& smaller : failure.input->smaller()) {
      left -= 1 + smaller->samples() / 300;
      if (left < 0) return;
      const auto why = judge.fault_of(*smaller, failure.seed);
      if (!why || why->fault != failure.why.fault) continue;
      failure.input = smaller;
      failure.why = *why;
      goes_on = true;
      break;
    }
  }
}

// The text of an input, for the report.
struct Shown {
  std::string text;
};
void showValue(const Shown& input, std::ostream& out) { out << input.text; }

}  // namespace

void Plainness::add(const Explanation& call) {
  constexpr double kError = 1e-2;  // another estimator's values differ by more
  ++calls;
  const Rgb off = call.off;
  const bool is_close = call.fault == Fault::value && is_finite(off) &&
                        std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)}) <=
                            kError * max_channel(call.value);
  explained += call.fault == Fault::none || call.fault == Fault::habit || is_close;
  with_habit += call.fault == Fault::none;
}

WildResult make_wild_calls(const WildTask& task, const Plainness& usual, std::uint64_t seed) {
  WildResult result;
  if (!usual.is_plain()) return result;
  Judge judge(task.calls, usual.keeps_habit(), result.wild);
  for (int i = 0; i < task.inputs; ++i) {
    const std::uint64_t own = seed * 0x9e3779b97f4a7c15 + static_cast<std::uint64_t>(i);
    RandomNumbers random(own);
    const WildPointer input = task.draw(random);
    if (!input) continue;
    const auto why = judge.fault_of(*input, own);
    if (!why) continue;
    result.failure = {input, own, *why, i};
    Plainness of_smaller;
    Judge again(task.calls, usual.keeps_habit(), of_smaller);
    make_smaller(again, *result.failure);
    return result;
  }
  return result;
}

namespace {

// For who wants to know how plain a file is (--gtest_output=xml).
void record(const std::string& kind, const Plainness& seen) {
  const auto add = [&](const std::string& name, int value) {
    testing::Test::RecordProperty(kind + name, value);
  };
  add("_calls", seen.calls);
  add("_explained", seen.explained);
  add("_with_habit", seen.with_habit);
}

// Returns how plain the submission's file is. Its usual calls are made once for all promises of the task.
const Plainness& plainness(const WildTask& task) {
  static const Plainness usual = [&] {
    Plainness seen;
    for (const Explanation& call : task.usual(seed())) seen.add(call);
    record("usual", seen);
    return seen;
  }();
  return usual;
}

}  // namespace

void never_wild() { makes_wild_calls = false; }

void expect_explained(const WildTask& task) {
  static std::optional<WildResult> result;
  if (!makes_wild_calls || !failures().empty()) return;
  const std::string promise = testing::UnitTest::GetInstance()->current_test_info()->name();
  for_all(
      [&] {
        const bool is_new = !result;
        if (is_new) {
          result = make_wild_calls(task, plainness(task), seed());
          record("wild", result->wild);
        }
        if (!result->failure || result->failure->why.promise != promise) return;
        const WildFailure& failure = *result->failure;
        if (!is_new) failure.input->ask(task.calls, failure.seed);  // for a debugger
        *rc::gen::just(Shown{failure.input->text()});
        fail("one call, in a scene of any kind", failure.why.got, failure.why.expected);
      },
      1);
}

bool needs_no_mean(const WildTask& task, const std::function<Explanations(int n)>& ask,
                   int samples) {
  if (!makes_wild_calls || !plainness(task).is_explained()) return false;
  constexpr int kSamples = 400, kMinCalls = 10, kMaxCalls = 200;
  const Explanations calls =
      ask(samples > kLong ? 1 : std::clamp(kSamples / std::max(1, samples), kMinCalls, kMaxCalls));
  return std::ranges::all_of(calls,
                             [](const Explanation& call) { return call.fault == Fault::none; });
}

}  // namespace grader::check
