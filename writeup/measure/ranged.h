#pragma once

#include <vector>

namespace writeup::measure {

// A number, and its 95 % interval.
struct Ranged {
  double value = 0;
  double low = 0;
  double high = 0;
};

// The interval is between two of the values, whatever they are distributed like (David and Nagaraja 2003, Order
// Statistics, section 7.1). Of less than six values it is from the least to the largest.
Ranged median_of(std::vector<double> values);

// The mean of two values or more that are independent.
Ranged mean_of(const std::vector<double>& values);

// Both are positive and independent.
Ranged product(const Ranged& a, const Ranged& b);

}  // namespace writeup::measure
