#pragma once

#include "pt/math/rgb.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

// Tests that turn agreement into a number. Every comparison has a level, the probability that right
// code fails it: 1e-9, so that all of the suite together stay below 1e-6.

namespace pt::proof {

inline constexpr double kLevel = 1e-9;

// The z whose absolute value a standard normal number exceeds with probability `level`.
inline double two_sided_threshold(double level) {
  double low = 0, high = 40;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (std::erfc(middle / std::sqrt(2.0)) > level ? low : high) = middle;
  }
  return high;
}

// The mean and variance of a sequence (Welford 1962).
struct Running {
  long n = 0;
  double mean = 0;
  double squares = 0;

  void add(double value) {
    ++n;
    const double distance = value - mean;
    mean += distance / static_cast<double>(n);
    squares += distance * (value - mean);
  }
  double variance() const { return squares / static_cast<double>(n - 1); }
  double standard_error() const { return std::sqrt(variance() / static_cast<double>(n)); }
};

struct RunningRgb {
  Running r, g, b;

  void add(Rgb value) {
    r.add(value.r);
    g.add(value.g);
    b.add(value.b);
  }
};

// The mean agrees with the true value within the errors of chance and of rounding. Each of the n
// additions may lose 2^-53, and each sample a few dozen of that.
inline void expect_mean(const Running& samples, double truth, const std::string& what) {
  ASSERT_GT(samples.n, 1) << what;
  const double rounding = (static_cast<double>(samples.n) + 100) * 0x1p-53 * std::abs(truth);
  const double bound = two_sided_threshold(kLevel) * samples.standard_error() + rounding;
  EXPECT_LE(std::abs(samples.mean - truth), bound)
      << what << ": " << samples.mean << " +- " << samples.standard_error() << " for " << truth
      << ", z = " << (samples.mean - truth) / samples.standard_error();
}

inline void expect_mean(const RunningRgb& samples, Rgb truth, const std::string& what) {
  expect_mean(samples.r, truth.r, what + ", red");
  expect_mean(samples.g, truth.g, what + ", green");
  expect_mean(samples.b, truth.b, what + ", blue");
}

// Compares a number without noise, the result of some dozens of operations. If these cancel, more
// roundings are allowed.
inline void expect_exact(double value, double truth, const std::string& what,
                         double roundings = 64) {
  EXPECT_LE(std::abs(value - truth), roundings * 0x1p-53 * std::abs(truth))
      << what << ": " << value << " for " << truth;
}

inline void expect_exact(Rgb value, Rgb truth, const std::string& what, double roundings = 64) {
  for (int c = 0; c < 3; ++c) expect_exact(value[c], truth[c], what, roundings);
}

// The probability that chi-square with this many degrees of freedom exceeds x: the regularised
// incomplete gamma function Q(k / 2, x / 2), by its series below the mean and by Lentz's continued
// fraction above.
inline double chi_square_tail(double chi_square, double degrees) {
  const double a = degrees / 2, x = chi_square / 2;
  if (!(x > 0)) return 1;
  const double front = std::exp(a * std::log(x) - x - std::lgamma(a));
  if (x < a + 1) {
    double term = 1 / a, sum = term;
    for (double k = a + 1; term > sum * 1e-17; k += 1) sum += term *= x / k;
    return 1 - front * sum;
  }
  double b = x + 1 - a, c = 1e300, d = 1 / b, h = d;
  for (int i = 1; i < 10000; ++i) {
    const double factor = -i * (i - a);
    b += 2;
    d = 1 / (factor * d + b);
    c = b + factor / c;
    h *= d * c;
    if (std::abs(d * c - 1) < 1e-15) break;
  }
  return front * h;
}

// Pearson's test of counts against expected counts. Bins that expect fewer than 25 are joined, and
// a count in an impossible bin is an error of its own.
inline void expect_counts(const std::vector<double>& counts, const std::vector<double>& expected,
                          const std::string& what) {
  ASSERT_EQ(counts.size(), expected.size());
  double sum = 0, rare_counts = 0, rare_expected = 0, total = 0, total_expected = 0;
  int used = 0;
  const auto use = [&](double count, double mean) {
    sum += (count - mean) * (count - mean) / mean;
    ++used;
  };
  for (std::size_t i = 0; i < counts.size(); ++i) {
    total += counts[i];
    total_expected += expected[i];
    if (expected[i] == 0) {
      EXPECT_EQ(counts[i], 0) << what << ", bin " << i;
    } else if (expected[i] < 25) {
      rare_counts += counts[i];
      rare_expected += expected[i];
    } else {
      use(counts[i], expected[i]);
    }
  }
  if (rare_expected >= 25) use(rare_counts, rare_expected);
  ASSERT_GE(used, 2) << what;
  EXPECT_NEAR(total_expected / total, 1, 1e-3) << what << ": the density does not sum to one";
  EXPECT_GE(chi_square_tail(sum, used - 1), kLevel)
      << what << ": chi-square " << sum << " with " << used - 1 << " degrees of freedom";
}

}  // namespace pt::proof
