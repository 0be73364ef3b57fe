#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace grader::check {

// How often a value occurs among others: how many different values there are, and how often the most
// frequent one occurs.
struct Repetition {
  std::size_t different = 0, most = 0;
};

template <class Value>
Repetition repetition(std::vector<Value> values) {
  std::ranges::sort(values);
  Repetition found;
  for (auto at = values.begin(); at != values.end(); ++found.different) {
    const auto next = std::find_if(at, values.end(), [&](const Value& v) { return v != *at; });
    found.most = std::max(found.most, static_cast<std::size_t>(next - at));
    at = next;
  }
  return found;
}

}  // namespace grader::check
