#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/generators/random_numbers.h"
#include "grader/check/generators/special.h"
#include "pt/geometry/box.h"
#include "pt/geometry/ray.h"

#include <cmath>

// The parts of the cases: boxes, points inside and beside them, and directions.

namespace grader::check::hit_box_inputs {

// The quantity that may be extreme.
enum class Extreme { none, scale, length, distance, all };

// A box of any proportions, with the world's origin inside or outside. If the scale is extreme, it
// may also be tiny, huge or far away.
inline pt::Box some_box(Extreme extreme = Extreme::none) {
  const bool any = extreme == Extreme::scale || extreme == Extreme::all;
  const double scale = any ? *magnitude(1e-9, 1e9) : *magnitude(0.1, 10);
  const double away = any && *whole(0, 3) == 3 ? 1e4 : 1;
  const pt::Vec3 center = scale * away * *point(3);
  const pt::Vec3 half =
      scale * pt::Vec3{*magnitude(1e-3, 10), *magnitude(1e-3, 10), *magnitude(1e-3, 10)};
  return {center - half, center + half};
}

inline pt::Box some_box(RandomNumbers& make, double size) {
  const pt::Vec3 center = size * make.vector(-3, 3), half = size * make.vector(0.3, 1.5);
  return {center - half, center + half};
}

// The same box with this thickness along an axis, as a part of its diagonal.
inline pt::Box flattened(pt::Box box, int axis, double thickness = 0) {
  box.max[axis] = box.min[axis] + thickness * length(box.extent());
  return box;
}

// The point at these fractions of the box's edges.
inline pt::Vec3 point_in(const pt::Box& box, pt::Vec3 fraction) {
  pt::Vec3 p;
  for (int axis = 0; axis < 3; ++axis) {
    p[axis] = box.min[axis] + fraction[axis] * (box.max[axis] - box.min[axis]);
  }
  return p;
}

inline pt::Vec3 well_inside(const pt::Box& box) {
  return point_in(box, {*real(0.01, 0.99), *real(0.01, 0.99), *real(0.01, 0.99)});
}

inline pt::Vec3 inside(const pt::Box& box, RandomNumbers& make) {
  return box.center() + 0.4 * make.between(-1, 1) * box.extent();
}

// The point p, moved along an axis until it is `gap` beyond the box's upper side (`out` is 1) or
// its lower side (-1). A negative gap is inside.
inline pt::Vec3 beyond(const pt::Box& box, pt::Vec3 p, int axis, double out, double gap) {
  p[axis] = (out > 0 ? box.max[axis] : box.min[axis]) + out * gap;
  return p;
}

inline double zero() { return *almost_zero(); }
inline double sign() { return *rc::gen::element(1.0, -1.0); }

inline double some_length(Extreme extreme = Extreme::none) {
  if (extreme != Extreme::length && extreme != Extreme::all) return *magnitude(1e-3, 1e3);
  return *whole(0, 1) == 1 ? *rc::gen::element(1e-9, 1e9) : *magnitude(1e-9, 1e9);
}

// Two of three directions have a special component. It is small, so that the ray is nearly parallel
// to the sides, or so small that 1 / d is huge, or 0, or -0.
inline pt::Vec3 some_direction(Extreme extreme = Extreme::none) {
  pt::Vec3 d = *direction();
  const int kind = *whole(0, 5), axis = *whole(0, 2);
  if (kind >= 2) {
    d[(axis + 1) % 3] += d[(axis + 1) % 3] < 0 ? -0.1 : 0.1;
    d[axis] = zero();
  }
  if (kind == 2) d[axis] = sign() * *magnitude(1e-200, 1e-6);
  if (kind == 3 || kind == 4) d[axis] = sign() * *magnitude(1e-6, 1e-2);
  return some_length(extreme) * d;
}

// A ray that is at the target at t = `way`.
inline pt::Ray ray_to(pt::Vec3 target, pt::Vec3 d, double way) { return {target - way * d, d}; }

// A ray whose line goes through the target. It starts `before` times the box's size before the
// target.
inline pt::Ray through(const pt::Box& box, pt::Vec3 target, pt::Vec3 d, double before) {
  return ray_to(target, d, before * length(box.extent()) / length(d));
}

}  // namespace grader::check::hit_box_inputs
