#include "grader/mistakes/battery.h"

#include "grader/check/language/fail.h"
#include "pt/math/uncertain.h"

#include <algorithm>
#include <cmath>

namespace grader::mistakes {

namespace {

// A call that hangs costs its whole time limit, so no call is made after it.
constexpr int kMaxTimeouts = 1;

// Each crash costs a new process. A task that crashes in so many calls from the first on is taken to
// crash in all of them.
constexpr std::size_t kMaxCrashesFromTheFirst = 20;

double central_moment(const std::vector<double>& values, double mean, int power) {
  double sum = 0;
  for (const double value : values) sum += std::pow(value - mean, power);
  return sum / static_cast<double>(values.size());
}

// A sum of n equal numbers is not exactly n times the number.
bool is_rounding_error(double variance, double mean) { return !(variance > 1e-24 * mean * mean); }

void add_mean(Answer& answer, const std::vector<double>& values) {
  const double mean = pt::mean_of(values).value, variance = central_moment(values, mean, 2);
  answer.values.push_back(mean);
  answer.errors.push_back(is_rounding_error(variance, mean)
                              ? 0
                              : std::sqrt(variance / static_cast<double>(values.size() - 1)));
}

// Adds the standard deviation over the mean, and its error from the fourth moment.
void add_spread(Answer& answer, const std::vector<double>& values) {
  const double mean = pt::mean_of(values).value, variance = central_moment(values, mean, 2);
  if (is_rounding_error(variance, mean) || !(std::abs(mean) > 0)) {
    answer.values.push_back(0);
    answer.errors.push_back(0);
    return;
  }
  const double spread = std::sqrt(variance) / std::abs(mean);
  const double n = static_cast<double>(values.size());
  const double kurtosis = central_moment(values, mean, 4) / (variance * variance);
  const double of_variance = std::sqrt(std::max(0.0, kurtosis - 1) / n) / 2;
  answer.values.push_back(spread);
  answer.errors.push_back(spread * std::hypot(of_variance, spread / std::sqrt(n)));
}

// Adds the share of the flags that are 1, and its error. The error is not zero, even if all flags
// are equal.
void add_share(Answer& answer, const std::vector<double>& flags) {
  const double n = static_cast<double>(flags.size()), share = pt::mean_of(flags).value;
  answer.values.push_back(share);
  answer.errors.push_back(std::sqrt((share * (1 - share) + 1 / n) / n));
}

std::vector<double> column(const std::vector<Battery::Numbers>& rows, std::size_t i) {
  std::vector<double> values;
  for (const Battery::Numbers& row : rows) values.push_back(row.at(i));
  return values;
}

}  // namespace

void Battery::record(const std::function<Answer()>& call) {
  if (timeouts_ >= kMaxTimeouts) {
    answers_.push_back({name(results::Cause::timeout), {}, {}});
    return;
  }
  if (crashes_ >= kMaxCrashesFromTheFirst && crashes_ == answers_.size()) {
    answers_.push_back(Answer(answers_.back()));
    ++crashes_;
    return;
  }
  try {
    answers_.push_back(call());
  } catch (const CallEnded& ended) {
    std::string words = name(ended.cause);
    // Two mistakes that end in different ways are two mistakes.
    if (ended.cause == results::Cause::crash && !ended.how.empty()) words += ": " + ended.how;
    answers_.push_back({words, {}, {}});
    timeouts_ += ended.cause == results::Cause::timeout ? 1 : 0;
    crashes_ += ended.cause == results::Cause::crash ? 1 : 0;
  } catch (const check::CaseFailed&) {
    answers_.push_back({name(results::Cause::bad_reply), {}, {}});  // a reply that is not a number
  }
}

void Battery::ask(const std::function<Numbers()>& call) {
  record([&] { return Answer{"", call(), {}}; });
}

void Battery::mean(int n, const Draws& draw) {
  const std::uint64_t seed = settings_.seed + 1000 * answers_.size();
  record([&] {
    const std::vector<Numbers> rows = draw(n * settings_.draws, seed);
    Answer answer;
    for (std::size_t i = 0; i < rows.at(0).size(); ++i) add_mean(answer, column(rows, i));
    return answer;
  });
}

void Battery::estimate(int n, const Colors& draw) {
  const std::uint64_t seed = settings_.seed + 1000 * answers_.size();
  record([&] {
    std::vector<double> r, g, b, brightness, black;
    for (const pt::Rgb& each : draw(n * settings_.draws, seed)) {
      r.push_back(each.r);
      g.push_back(each.g);
      b.push_back(each.b);
      brightness.push_back(luminance(each));
      black.push_back(flag(is_black(each)));
    }
    Answer answer;
    for (const auto* channel : {&r, &g, &b}) add_mean(answer, *channel);
    add_spread(answer, brightness);
    add_share(answer, black);
    return answer;
  });
}

Battery::Numbers numbers(pt::Vec3 v) { return {v.x, v.y, v.z}; }
Battery::Numbers numbers(pt::Rgb c) { return {c.r, c.g, c.b}; }

Battery::Numbers use_of_sampler(const std::function<Battery::Numbers(pt::Sampler& sampler)>& call) {
  const pt::Sampler start(5);
  pt::Sampler first = start, second = start, by_one = start;
  by_one.next_1d();
  const bool same = call(first) == call(second);
  const double moved = first.state() == start.state() ? 0 : first.state() == by_one.state() ? 1 : 2;
  return {moved, flag(same)};
}

}  // namespace grader::mistakes
