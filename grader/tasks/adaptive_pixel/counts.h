#pragma once

#include "grader/check/generators/precision.h"
#include "grader/check/language/property.h"
#include "grader/tasks/adaptive_pixel/inputs.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

// The numbers of samples after which a right solution may stop.

namespace grader::check::adaptive_pixel_inputs {

// Mean and variance of the luminance of the first n samples. The variance divides by n. It is
// computed in two passes, so that rounding errors are negligible where it is zero.
struct Statistics {
  double mean = 0, variance = 0;
};

inline Statistics statistics(const Case& c, int n) {
  Statistics s;
  for (int i = 0; i < n; ++i) s.mean += luminance(c.seen[i]) / n;
  for (int i = 0; i < n; ++i) {
    const double off = luminance(c.seen[i]) - s.mean;
    s.variance += off * off / n;
  }
  return s;
}

// The sides of the condition may differ by so much of their size, and either decision is right.
inline constexpr double kConditionPrecision = 2e-5;

enum class Verdict { done, not_done, either };

// Returns whether a pixel is done after n samples. Sigma divides by n or, if `divides_by_n` is
// false, by n - 1. The result is `either` if both sides of the condition are equal to the precision
// of the contract, or if rounding errors decide. A variance that is computed as a small difference,
// s2 - s1^2 / n, has rounding errors of up to n 2^-52 of the squared mean, or n 2^-23 in single precision.
inline Verdict done_after(const Case& c, int n, bool divides_by_n) {
  const Statistics s = statistics(c, n);
  const double share = divides_by_n ? 1 : static_cast<double>(n) / (n - 1);
  const double half_interval_squared = 1.96 * 1.96 * s.variance * share / n;
  const double limit_squared = std::pow(c.settings.tolerance * s.mean, 2);
  const double rounding = is_single_precision_allowed() ? 0x1p-21 : 0x1p-50;
  const double doubt =
      2 * kConditionPrecision * limit_squared + rounding * (s.mean * s.mean + s.variance);
  if (half_interval_squared < limit_squared - doubt) return Verdict::done;
  return half_interval_squared > limit_squared + doubt ? Verdict::not_done : Verdict::either;
}

// Returns whether a right solution may stop after n samples.
inline bool may_stop(const Case& c, int n, bool divides_by_n) {
  const int batch = c.settings.batch, most = c.settings.max_samples;
  if (n < 1 || n > most || (n != most && n % batch != 0)) return false;
  for (int k = batch; k < n; k += batch) {
    if (done_after(c, k, divides_by_n) == Verdict::done) return false;
  }
  return n == most || done_after(c, n, divides_by_n) != Verdict::not_done;
}

// Returns whether all right solutions stop after the same number of samples.
inline bool has_one_count(const Case& c) {
  for (int n = c.settings.batch; n < c.settings.max_samples; n += c.settings.batch) {
    const Verdict verdict = done_after(c, n, true);
    if (verdict == Verdict::either || verdict != done_after(c, n, false)) return false;
    if (verdict == Verdict::done) return true;
  }
  return true;
}

inline int right_count(const Case& c) {
  int n = c.settings.batch;
  while (n < c.settings.max_samples && done_after(c, n, true) == Verdict::not_done) {
    n += c.settings.batch;
  }
  return std::min(n, c.settings.max_samples);
}

// Returns the number of samples that the task reports. Fails if it never called radiance().
inline int samples_of(const Answer& answer) {
  expect(!answer.calls.empty(), "a call of radiance()", "none");
  return answer.estimate.samples;
}

// The two sides of the condition after n samples; nothing where n cannot be a number of samples.
inline std::string condition_after(const Case& c, int n) {
  if (n < 2 || n > std::ssize(c.seen)) return "";
  const Statistics s = statistics(c, n);
  const double sigma = std::sqrt(s.variance * n / (n - 1));
  const double interval = 1.96 * sigma / std::sqrt(n), limit = c.settings.tolerance * s.mean;
  return fmt::format(
      ": after {} the mean is {:.4g} and sigma {:.4g}, so 1.96 sigma / sqrt(n) is {:.4g}, and {} "
      "tolerance * mean, {:.4g}",
      n, s.mean, sigma, interval, interval < limit ? "below" : "not below", limit);
}

// Fails the case with the condition at the first place where a right solution decides otherwise.
[[noreturn]] inline void fail_count(const std::string& which, const Case& c, int got, int right,
                                    const std::string& or_else) {
  const bool never_stopped = got == c.settings.max_samples && right < got;
  fail("",
       fmt::format("{} samples{}{}", got, which,
                   never_stopped ? ", the maximum: it never stopped" : ""),
       fmt::format("{} samples{}{}", right, or_else, condition_after(c, std::min(got, right))));
}

inline void expect_count(const std::string& which, const Case& c, int got, int right) {
  if (got != right) fail_count(which, c, got, right, "");
}

inline void expect_right_count(const Case& c, const Answer& answer) {
  const int n = answer.estimate.samples;
  if (may_stop(c, n, true) || may_stop(c, n, false)) return;
  const auto calls = std::ssize(answer.calls);
  fail_count(calls == n ? "" : fmt::format(", but {} calls of radiance()", calls), c, n,
             right_count(c), has_one_count(c) ? "" : " (or what dividing by n - 1 gives)");
}

}  // namespace grader::check::adaptive_pixel_inputs
