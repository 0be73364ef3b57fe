#include "measure/calls/results.h"

#include "pt/math/uncertain.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace measure::calls {

namespace {

// Adaptive sampling stops earlier if the first samples happen to be alike, so its mean is a little
// off in every right program.
constexpr double kAdaptiveBias = 0.05;
constexpr double kSmallest = 1e-17;  // below what double precision resolves: an error of zero

bool counts(const About& about, const Row& row) {
  return row.problem.empty() && mistake(about, row).empty();
}

bool is_clearly_less(const Ranged& a, const Ranged& b) { return a.high < b.low; }

bool beats(const About& about, const Row& a, const Row& b) {
  const Ranged off_a = accuracy(about, a), off_b = accuracy(about, b);
  if (is_clearly_less(b.nanoseconds, a.nanoseconds) || is_clearly_less(off_b, off_a)) return false;
  return is_clearly_less(a.nanoseconds, b.nanoseconds) || is_clearly_less(off_a, off_b);
}

constexpr double kDeviations = 1.96;

}  // namespace

Ranged accuracy(const About& about, const Row& row) {
  if (about.kind == Kind::estimator) {
    const auto root = [](double square) { return std::sqrt(std::max(square, 0.0)); };
    return {root(row.variance.value), root(row.variance.low), root(row.variance.high)};
  }
  if (about.kind == Kind::tree) {
    const double tests = row.found.boxes + row.found.primitives;
    return {tests, tests, tests};
  }
  const double error = std::max(kSmallest, row.found.errors[0]);
  return {error, error / std::sqrt(2.0), error * std::sqrt(2.0)};
}

std::string mistake(const About& about, const Row& row) {
  if (row.found.wrong > 0) {
    return fmt::format("wrong for {:.2g} % of the inputs", 100 * row.found.wrong);
  }
  if (about.kind != Kind::estimator) return "";
  // Five standard errors, plus the rounding errors that contracts allow.
  const double half = 2.5 * (row.mean.high - row.mean.low) + 1e-4;
  const double allowed = half + (about.chooses_samples ? kAdaptiveBias : 0);
  if (std::abs(row.mean.value - 1) <= allowed) return "";
  return fmt::format("its mean is {:.3g} of the right one", row.mean.value);
}

bool own_code_fails(const Results& results) {
  for (const Table& table : results.tables) {
    for (const Row& row : table.rows) {
      const bool fails = !row.problem.empty() || !mistake(*results.about, row).empty();
      if (row.is_own && fails) return true;
    }
  }
  return false;
}

std::vector<std::vector<bool>> pareto_fronts(const About& about, const std::vector<Table>& tables) {
  std::vector<std::vector<bool>> fronts;
  for (const Table& table : tables) {
    fronts.emplace_back();
    for (const Row& row : table.rows) {
      bool is_best = counts(about, row);
      for (const Table& other : tables) {
        if (&other != &table && !about.one_front) continue;
        for (const Row& rival : other.rows) {
          if (counts(about, rival) && beats(about, rival, row)) is_best = false;
        }
      }
      fronts.back().push_back(is_best);
    }
  }
  return fronts;
}

Ranged work(const Row& row, const Row& reference) {
  if (&row == &reference) return {1, 1, 1};
  const Ranged& variance = reference.variance;
  const double square = variance.value * variance.value;
  if (!(square > 0)) return {};
  const Ranged inverse{1 / variance.value,
                       1 / variance.value - (variance.high - variance.value) / square,
                       1 / variance.value + (variance.value - variance.low) / square};
  return product(row.ratio, product(row.variance, inverse));
}

Ranged median_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  // The number of values below the median is distributed like the heads of as many coins.
  const double half = kDeviations * std::sqrt(n) / 2;
  const auto at = [&](double rank) {
    return values[static_cast<std::size_t>(std::clamp(rank, 0.0, n - 1))];
  };
  const double middle = (n - 1) / 2;
  return {0.5 * (at(std::floor(middle)) + at(std::ceil(middle))), at(std::floor(n / 2 - half)),
          at(std::ceil(n / 2 + half) - 1)};
}

Ranged mean_of(const std::vector<double>& values) {
  const pt::Uncertain mean = pt::mean_of(values);
  const double half = kDeviations * mean.error;
  return {mean.value, mean.value - half, mean.value + half};
}

Ranged product(const Ranged& a, const Ranged& b) {
  const double value = a.value * b.value;
  const auto part = [](const Ranged& x) { return (x.high - x.low) / (2 * x.value); };
  const double factor = std::exp(std::hypot(part(a), part(b)));
  return {value, value / factor, value * factor};
}

}  // namespace measure::calls
