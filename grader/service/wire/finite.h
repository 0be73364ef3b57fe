#pragma once

#include "grader/service/wire/fields.h"

#include <cmath>
#include <optional>
#include <vector>

// The judge's end: checks the numbers of an answer. No answer may contain a NaN, and only the end
// of a range may be infinite.

namespace grader::wire {

inline bool has_valid_numbers(double value) { return std::isfinite(value); }
inline bool has_valid_numbers(int) { return true; }
inline bool has_valid_numbers(bool) { return true; }

inline bool has_valid_numbers(const pt::Interval& interval) {
  return !std::isnan(interval.min) && !std::isnan(interval.max);
}

inline bool has_valid_numbers(const pt::Ray& ray) {
  return is_finite(ray.origin) && is_finite(ray.direction) && !std::isnan(ray.t_min) &&
         !std::isnan(ray.t_max);
}

template <HasFields T>
bool has_valid_numbers(const T& value);

template <class T>
bool has_valid_numbers(const std::vector<T>& list) {
  for (const T& element : list) {
    if (!has_valid_numbers(element)) return false;
  }
  return true;
}

template <class T>
bool has_valid_numbers(const std::optional<T>& value) {
  return !value || has_valid_numbers(*value);
}

template <HasFields T>
bool has_valid_numbers(const T& value) {
  return std::apply([](const auto&... members) { return (has_valid_numbers(members) && ...); },
                    Fields<T>::of(value));
}

}  // namespace grader::wire
