#pragma once

#include "grader/service/wire/fields.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The judge's end: checks the numbers of an answer. No answer may contain a NaN, and only the end
// of a range may be infinite.

namespace grader::wire {

// The first number of an answer that is not allowed.
struct BadNumber {
  std::string member;  // "wi.x"; empty: the answer itself
  double value = 0;
};
using MaybeBad = std::optional<BadNumber>;

inline MaybeBad bad_number(double value) {
  return std::isfinite(value) ? MaybeBad() : BadNumber{"", value};
}
inline MaybeBad bad_number(int) { return std::nullopt; }
inline MaybeBad bad_number(bool) { return std::nullopt; }

// Puts the name of a member, or [i], before the rest of the way to the number.
inline MaybeBad inside(const std::string& name, MaybeBad bad) {
  if (bad) {
    const bool joins = bad->member.empty() || bad->member.front() == '[';
    bad->member = name + (joins ? "" : ".") + bad->member;
  }
  return bad;
}

inline MaybeBad bad_end(const char* name, double value) {
  return std::isnan(value) ? BadNumber{name, value} : MaybeBad();
}

inline MaybeBad bad_number(const pt::Interval& interval) {
  const MaybeBad min = bad_end("min", interval.min);
  return min ? min : bad_end("max", interval.max);
}

template <HasFields T>
MaybeBad bad_number(const T& value);

inline MaybeBad bad_number(const pt::Ray& ray) {
  if (MaybeBad bad = bad_number(ray.origin)) return inside("origin", std::move(bad));
  if (MaybeBad bad = bad_number(ray.direction)) return inside("direction", std::move(bad));
  const MaybeBad min = bad_end("t_min", ray.t_min);
  return min ? min : bad_end("t_max", ray.t_max);
}

template <class T>
MaybeBad bad_number(const std::vector<T>& list) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (MaybeBad bad = bad_number(list[i])) {
      return inside("[" + std::to_string(i) + "]", std::move(bad));
    }
  }
  return std::nullopt;
}

template <class T>
MaybeBad bad_number(const std::optional<T>& value) {
  return value ? bad_number(*value) : std::nullopt;
}

// Name i of "x, y, z".
inline std::string name_of_field(std::string_view names, std::size_t i) {
  for (; i > 0; --i) names.remove_prefix(names.find(", ") + 2);
  return std::string(names.substr(0, names.find(", ")));
}

template <HasFields T>
MaybeBad bad_number(const T& value) {
  MaybeBad bad;
  std::size_t i = 0;
  const auto is_bad = [&](const auto& member) {
    bad = bad_number(member);
    i += bad ? 0 : 1;
    return bad.has_value();
  };
  std::apply([&](const auto&... members) { (is_bad(members) || ...); }, Fields<T>::of(value));
  return bad ? inside(name_of_field(Fields<T>::names, i), std::move(bad)) : std::nullopt;
}

}  // namespace grader::wire
