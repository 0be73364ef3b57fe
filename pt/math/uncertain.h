#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

// Numbers that were measured several times.

namespace pt {

// A measured number and its standard error.
struct Uncertain {
  double value = 0;
  double error = 0;
};

// The mean of at least one number, all independent, with the standard error from their spread; 0 for a single number.
[[nodiscard]] inline Uncertain mean_of(const std::vector<double>& values) {
  assert(!values.empty());
  const auto n = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  for (const double value : values) squares += (value - sum / n) * (value - sum / n);
  return {sum / n, std::sqrt(squares / std::max(1.0, n - 1) / n)};
}

// The number in the middle of at least one number; of an even count, the larger of the two.
[[nodiscard]] inline double median_of(std::vector<double> values) {
  assert(!values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace pt
