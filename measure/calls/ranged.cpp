#include "measure/calls/ranged.h"

#include <algorithm>
#include <cmath>

namespace measure::calls {

namespace {

constexpr double kDeviations = 1.96;

}  // namespace

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
  const auto n = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  const double mean = sum / n;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double half = kDeviations * std::sqrt(squares / (n - 1) / n);
  return {mean, mean - half, mean + half};
}

Ranged product(const Ranged& a, const Ranged& b) {
  const double value = a.value * b.value;
  const auto part = [](const Ranged& x) { return (x.high - x.low) / (2 * x.value); };
  const double factor = std::exp(std::hypot(part(a), part(b)));
  return {value, value / factor, value * factor};
}

}  // namespace measure::calls
