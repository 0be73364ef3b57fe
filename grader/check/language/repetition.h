#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace grader::check {

// Repetition of values: the number of different values, and how often the most frequent one occurs.
struct Repetition {
  std::size_t all = 0, different = 0, most = 0;

  // Both are so rare among values of a continuous density, even in pairs that mirror each other, that
  // they happen less than once in a billion times.
  bool one_is_frequent() const { return most > 4; }
  bool half_are_repeated() const { return 2 * different < all; }
};

template <class Value>
Repetition repetition(std::vector<Value> values) {
  std::ranges::sort(values);
  Repetition found{values.size()};
  for (auto at = values.begin(); at != values.end(); ++found.different) {
    const auto next = std::find_if(at, values.end(), [&](const Value& v) { return v != *at; });
    found.most = std::max(found.most, static_cast<std::size_t>(next - at));
    at = next;
  }
  return found;
}

}  // namespace grader::check
