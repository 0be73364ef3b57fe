#pragma once

#include <vector>

namespace measure::calls {

// A number, and its 95 % interval.
struct Ranged {
  double value = 0;
  double low = 0;
  double high = 0;
};

// The interval ends at two of the values, for any distribution (David and Nagaraja 2003, Order
// Statistics, section 7.1). For fewer than six values these are the smallest and the largest.
Ranged median_of(std::vector<double> values);

// The mean of two or more independent values.
Ranged mean_of(const std::vector<double>& values);

// Both are positive and independent.
Ranged product(const Ranged& a, const Ranged& b);

}  // namespace measure::calls
