#pragma once

#include "pt/geometry/box.h"
#include "pt/geometry/ray.h"

#include <algorithm>
#include <cmath>

// The right answers for any box and ray, within the contract's precision.

namespace grader::check::hit_box_inputs {

// Returns the largest coordinate. The contract's precision is relative to it.
inline double size_of(const pt::Box& box, const pt::Ray& ray) {
  return std::max({max_abs(ray.origin), max_abs(box.min), max_abs(box.max)});
}

// The contract's precision.
inline constexpr double kPrecision = 1e-12;

struct Ends {
  long double low = -pt::kInfinity, high = pt::kInfinity;
};

// The part of a ray inside a box, in extended precision. `enter` and `leave` are ranges, since
// every plane may be moved by the contract's precision. Planes that are parallel to the ray do not
// move.
struct Part {
  Ends enter{-pt::kInfinity, -pt::kInfinity}, leave{pt::kInfinity, pt::kInfinity};

  bool is_hit() const { return enter.high <= leave.low; }
  bool is_miss() const { return enter.low > leave.high; }
};

// A miss: the ray leaves before it enters.
inline constexpr Part kNowhere{{1, 1}, {0, 0}};

inline void cut_to_slab(Part& part, const pt::Box& box, const pt::Ray& ray, int axis,
                        double precision) {
  const long double o = ray.origin[axis], d = ray.direction[axis];
  if (d == 0) {
    if (!(o >= box.min[axis] && o <= box.max[axis])) part = kNowhere;
    return;
  }
  const long double a = (box.min[axis] - o) / d, b = (box.max[axis] - o) / d;
  const long double error = precision * size_of(box, ray) / std::abs(d);
  const long double enter = std::min(a, b), leave = std::max(a, b);
  part.enter = {std::max(part.enter.low, enter - error), std::max(part.enter.high, enter + error)};
  part.leave = {std::min(part.leave.low, leave - error), std::min(part.leave.high, leave + error)};
}

// Returns the part of the whole line that is inside the box, also behind the ray's origin.
inline Part on_the_line(const pt::Box& box, const pt::Ray& ray, double precision = kPrecision) {
  Part part;
  for (int axis = 0; axis < 3; ++axis) cut_to_slab(part, box, ray, axis, precision);
  return part;
}

// Returns the part of the ray that is inside the box and in the ray's range.
inline Part expected(const pt::Box& box, const pt::Ray& ray, double precision = kPrecision) {
  Part part = on_the_line(box, ray, precision);
  const long double first = ray.t_min, last = ray.t_max;
  part.enter = {std::max(part.enter.low, first), std::max(part.enter.high, first)};
  part.leave = {std::min(part.leave.low, last), std::min(part.leave.high, last)};
  return part;
}

}  // namespace grader::check::hit_box_inputs
