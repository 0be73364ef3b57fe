#pragma once

#include "grader/property/generators.h"
#include "grader/property/show.h"
#include "pt/geometry/box.h"
#include "pt/geometry/ray.h"

#include <algorithm>
#include <cmath>

// Boxes, and rays that are known to meet or to miss them.

namespace grader::hit_box_cases {

inline constexpr double kEpsilon = 0x1p-53;

struct Case {
  pt::Box box;
  pt::Ray ray;
};

inline void showValue(const Case& c, std::ostream& out) { show_lines(out, c.box, c.ray); }

// Boxes of all proportions, the origin of space inside or outside.
inline pt::Box some_box() {
  const pt::Vec3 center = *point(3);
  const pt::Vec3 half{*magnitude(1e-2, 10), *magnitude(1e-2, 10), *magnitude(1e-2, 10)};
  return {center - half, center + half};
}

// The point at fractions (a, b, c) of the box's edges.
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

inline double zero() { return *rc::gen::element(0.0, -0.0); }

// Of any length. Every other one has a component so small that 1 / d is huge, or zero, or -0.
inline pt::Vec3 some_direction() {
  pt::Vec3 d = *direction();
  if (*whole(0, 1) == 1) {
    const int axis = *whole(0, 2);
    const bool tiny = *whole(0, 1) == 0;
    d[axis] = tiny ? *rc::gen::element(1.0, -1.0) * *magnitude(1e-200, 1e-6) : zero();
    d[(axis + 1) % 3] += d[(axis + 1) % 3] < 0 ? -0.1 : 0.1;
  }
  return *magnitude(1e-3, 1e3) * d;
}

// A ray whose line goes through the target, from `before` of the box's sizes away.
inline pt::Ray through(const pt::Box& box, pt::Vec3 target, pt::Vec3 d, double before) {
  return {target - (before * length(box.extent()) / length(d)) * d, d};
}

// Where the line is between two planes of one axis, in the extended precision that there is.
struct Part {
  long double min = -pt::kInfinity, max = pt::kInfinity;
  long double min_error = 0, max_error = 0;
};

inline Part between_planes(const pt::Box& box, const pt::Ray& ray, int axis) {
  const long double o = ray.origin[axis], d = ray.direction[axis];
  if (d == 0) return o >= box.min[axis] && o <= box.max[axis] ? Part{} : Part{1, 0, 0, 0};
  const long double a = (box.min[axis] - o) / d, b = (box.max[axis] - o) / d;
  const double size = max_abs(ray.origin) + std::max(max_abs(box.min), max_abs(box.max));
  const long double error = 16 * kEpsilon * size / std::abs(d);
  return {std::min(a, b), std::max(a, b), error, error};
}

// The slabs' common part, not yet cut to the ray's range.
inline Part expected(const pt::Box& box, const pt::Ray& ray) {
  Part all;
  for (int axis = 0; axis < 3; ++axis) {
    const Part part = between_planes(box, ray, axis);
    if (part.min > all.min) all.min = part.min, all.min_error = part.min_error;
    if (part.max < all.max) all.max = part.max, all.max_error = part.max_error;
  }
  return all;
}

inline rc::Gen<Case> aimed_inside() {
  return rc::gen::exec([] {
    const pt::Box box = some_box();
    return Case{box, through(box, well_inside(box), some_direction(), *magnitude(1e-2, 100))};
  });
}

// Past an edge of the box, as seen along a third axis: beside the corner of a rectangle, on a line
// that has the whole rectangle on one side.
inline rc::Gen<Case> passing() {
  return rc::gen::exec([] {
    const pt::Box box = some_box();
    const int i = *whole(0, 2), j = (i + *whole(1, 2)) % 3, k = 3 - i - j;
    const double out_i = *rc::gen::element(1.0, -1.0), out_j = *rc::gen::element(1.0, -1.0);
    const double angle = *real(0.02, pt::kPi / 2 - 0.02);
    const double gap = *magnitude(1e-6, 3) * length(box.extent());
    pt::Vec3 p = well_inside(box), d;
    p[i] = (out_i > 0 ? box.max[i] : box.min[i]) + out_i * gap * std::cos(angle);
    p[j] = (out_j > 0 ? box.max[j] : box.min[j]) + out_j * gap * std::sin(angle);
    d[i] = -out_i * std::sin(angle);
    d[j] = out_j * std::cos(angle);
    d[k] = *real(-1, 1);
    return Case{box, through(box, p, *rc::gen::element(1.0, -1.0) * *magnitude(1e-3, 1e3) * d,
                             *magnitude(1e-2, 30))};
  });
}

// One or two components of the direction are 0 or -0, and the line is in those slabs or, in
// `beside` of them, not.
inline rc::Gen<Case> along_axes(bool beside) {
  return rc::gen::exec([=] {
    const pt::Box box = some_box();
    const int axis = *whole(0, 2), zeros = *whole(1, 2);
    pt::Vec3 target = well_inside(box);
    pt::Vec3 d{*real(0.1, 1), *real(0.1, 1), *real(0.1, 1)};
    for (int i = 0; i < 3; ++i) d[i] *= *rc::gen::element(1.0, -1.0);
    for (int i = 0; i < zeros; ++i) d[(axis + i) % 3] = zero();
    if (beside) {
      const double gap = *magnitude(1e-6, 10);
      target[axis] = *whole(0, 1) == 0 ? box.min[axis] - gap : box.max[axis] + gap;
    }
    return Case{box, through(box, target, d, *real(-0.1, 10))};
  });
}

inline double on_grid(double x) { return std::round(x * 0x1p20) * 0x1p-20; }

inline pt::Vec3 grid_point(double size) {
  return {on_grid(*real(-size, size)), on_grid(*real(-size, size)), on_grid(*real(-size, size))};
}

// A ray that grazes an edge or a corner of a triangle's box. All numbers are multiples of 2^-20, so
// that target - origin is exact and the ray is exactly at the target at t = 1.
inline rc::Gen<Case> grazing() {
  return rc::gen::exec([] {
    pt::Box box;
    for (int corner = 0; corner < 3; ++corner) box.grow(grid_point(4));
    const int flat = *whole(0, 5);
    if (flat < 3) box.max[flat] = box.min[flat];
    const int along = *whole(0, 3);  // the edge's axis, or a corner
    pt::Vec3 target;
    for (int i = 0; i < 3; ++i) target[i] = *rc::gen::element(box.min[i], box.max[i]);
    if (along < 3) target[along] = on_grid(box.center()[along]);
    const pt::Vec3 origin = grid_point(15);
    return Case{box, {origin, target - origin}};
  });
}

}  // namespace grader::hit_box_cases
