#pragma once

#include "grader/check/language/exact.h"
#include "pt/geometry/box.h"
#include "pt/geometry/ray.h"

#include <algorithm>

// The right answers for any box and ray, within the contract's precision.

namespace grader::check::hit_box_inputs {

// Returns the largest coordinate. The contract's precision is relative to it.
inline double size_of(const pt::Box& box, const pt::Ray& ray) {
  return std::max({max_abs(ray.origin), max_abs(box.min), max_abs(box.max)});
}

// The contract's precision.
inline constexpr double kPrecision = 1e-12;

struct Ends {
  Exact low, high;
};

// The part of a ray inside a box. `enter` and `leave` are ranges, since every plane may be moved by the
// contract's precision. Planes that are parallel to the ray do not move.
struct Part {
  Ends enter{-pt::kInfinity, -pt::kInfinity}, leave{pt::kInfinity, pt::kInfinity};

  bool is_hit() const { return enter.high <= leave.low; }
  bool is_miss() const { return enter.low > leave.high; }
};

// A miss: the ray leaves before it enters.
inline constexpr Part kNowhere{{pt::kInfinity, pt::kInfinity}, {-pt::kInfinity, -pt::kInfinity}};

inline void cut_to_slab(Part& part, const pt::Box& box, const pt::Ray& ray, int axis,
                        double precision) {
  const Exact o = ray.origin[axis], d = ray.direction[axis];
  if (d == 0) {
    if (!(o >= box.min[axis] && o <= box.max[axis])) part = kNowhere;
    return;
  }
  const Exact a = (box.min[axis] - o) / d, b = (box.max[axis] - o) / d;
  const Exact error = Exact(precision) * size_of(box, ray) / (d < 0 ? -d : d);
  const Exact enter = std::min(a, b), leave = std::max(a, b);
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
  const Exact first = ray.t_min, last = ray.t_max;
  part.enter = {std::max(part.enter.low, first), std::max(part.enter.high, first)};
  part.leave = {std::min(part.leave.low, last), std::min(part.leave.high, last)};
  return part;
}

// The error of an end, where 1 is what the contract allows on that side.
inline double off(double got, const Exact& right, const Ends& allowed) {
  const Exact error = Exact(got) - right;
  if (error == 0) return 0;
  return rounded(error / ((error < 0 ? allowed.low : allowed.high) - right));
}

// The larger error of both ends, of a ray that hits.
inline double off(const pt::Box& box, const pt::Ray& ray, const pt::Interval& got) {
  const Part right = expected(box, ray, 0), allowed = expected(box, ray);
  return std::max(off(got.min, right.enter.low, allowed.enter),
                  off(got.max, right.leave.low, allowed.leave));
}

}  // namespace grader::check::hit_box_inputs
