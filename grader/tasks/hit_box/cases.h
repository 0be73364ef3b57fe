#pragma once

#include "grader/check/generators.h"
#include "grader/check/show.h"
#include "grader/tasks/hit_box/expected.h"
#include "pt/geometry/box.h"
#include "pt/geometry/ray.h"

#include <algorithm>
#include <cmath>

// Boxes, and rays that are known to meet or to miss them.

namespace grader::check::hit_box_cases {

struct Case {
  pt::Box box;
  pt::Ray ray;
};

inline void showValue(const Case& c, std::ostream& out) { show_lines(out, c.box, c.ray); }

// The quantity that may be extreme.
enum class Extreme { none, scale, length, distance };

// A box of any proportions, with the world's origin inside or outside. If the scale is extreme, it
// may also be tiny, huge or far away.
inline pt::Box some_box(Extreme extreme = Extreme::none) {
  const bool any = extreme == Extreme::scale;
  const double scale = any ? *magnitude(1e-9, 1e9) : *magnitude(0.1, 10);
  const double away = any && *whole(0, 3) == 3 ? 1e4 : 1;
  const pt::Vec3 center = scale * away * *point(3);
  const pt::Vec3 half =
      scale * pt::Vec3{*magnitude(1e-3, 10), *magnitude(1e-3, 10), *magnitude(1e-3, 10)};
  return {center - half, center + half};
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

inline double zero() { return *rc::gen::element(0.0, -0.0); }
inline double sign() { return *rc::gen::element(1.0, -1.0); }

inline double some_length(Extreme extreme = Extreme::none) {
  if (extreme == Extreme::length && *whole(0, 1) == 1) return *rc::gen::element(1e-9, 1e9);
  return extreme == Extreme::length ? *magnitude(1e-9, 1e9) : *magnitude(1e-3, 1e3);
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

// A ray whose line goes through the target. It starts `before` times the box's size before the
// target.
inline pt::Ray through(const pt::Box& box, pt::Vec3 target, pt::Vec3 d, double before) {
  return {target - (before * length(box.extent()) / length(d)) * d, d};
}

// The distance from a ray's origin to its target, in sizes of the box. Half of the extreme ones are so
// large that the squares of distances, in double, say nothing about the box.
inline double some_distance(Extreme extreme = Extreme::none) {
  if (extreme != Extreme::distance) return *magnitude(1e-2, 100);
  return *rc::gen::oneOf(magnitude(100, 1e7), magnitude(1e7, 1e9));
}

inline rc::Gen<Case> aimed_inside(Extreme extreme = Extreme::none) {
  return rc::gen::exec([=] {
    const pt::Box box = some_box(extreme);
    return Case{box,
                through(box, well_inside(box), some_direction(extreme), some_distance(extreme))};
  });
}

// A ray at a point of a side that faces it, at steep and flat angles.
inline rc::Gen<Case> aimed_at_a_side(Extreme extreme = Extreme::none) {
  return rc::gen::exec([=] {
    const pt::Box box = some_box(extreme);
    const int axis = *whole(0, 2);
    const double side = *rc::gen::element(0.0, 1.0);
    pt::Vec3 fraction{*real(0.05, 0.95), *real(0.05, 0.95), *real(0.05, 0.95)};
    pt::Vec3 d{*real(-1, 1), *real(-1, 1), *real(-1, 1)};
    fraction[axis] = side;
    d[axis] = (side == 0 ? 1 : -1) * (*whole(0, 1) == 0 ? 1 : *magnitude(1e-5, 1));
    return Case{box, through(box, point_in(box, fraction), some_length(extreme) * d,
                             some_distance(extreme))};
  });
}

// A ray that passes beside an edge of the box. Seen along that edge, the box is a rectangle, and
// the ray passes beside one of its corners on a line that has the whole rectangle on one side.
inline rc::Gen<Case> passing(Extreme extreme = Extreme::none) {
  return rc::gen::exec([=] {
    const pt::Box box = some_box(extreme);
    const int i = *whole(0, 2), j = (i + *whole(1, 2)) % 3, k = 3 - i - j;
    const double out_i = sign(), out_j = sign();
    const double angle = *real(0.02, pt::kPi / 2 - 0.02);
    const double before =
        extreme == Extreme::distance ? some_distance(extreme) : *magnitude(1e-2, 30);
    const double size = length(box.extent());
    const double least = 1e-10 * (max_abs(box.center()) + before * size);
    const double gap = std::max(*magnitude(1e-6, 3) * size, least);
    pt::Vec3 p = well_inside(box), d;
    p[i] = (out_i > 0 ? box.max[i] : box.min[i]) + out_i * gap * std::cos(angle);
    p[j] = (out_j > 0 ? box.max[j] : box.min[j]) + out_j * gap * std::sin(angle);
    d[i] = -out_i * std::sin(angle);
    d[j] = out_j * std::cos(angle);
    d[k] = *real(-1, 1);
    return Case{box, through(box, p, sign() * some_length(extreme) * d, before)};
  });
}

// A ray that is almost parallel to a side and crosses its plane half way to the box: inwards, and it
// meets the box, or outwards, and it passes. On the way it moves only some 1e-11 to 1e-5 of the way
// across, which is ten times the contract's precision or more.
inline rc::Gen<Case> crossing_on_the_way(bool inwards, Extreme extreme = Extreme::none) {
  return rc::gen::exec([=] {
    const pt::Box box = some_box();
    const int axis = *whole(0, 2);
    const double out = sign();
    const double way = *magnitude(10, 1e4) * std::max(length(box.extent()), size_of(box, {}));
    const double slope = std::min(*magnitude(2e-11, 1e-5), 0.8 * box.extent()[axis] / way);
    const double beyond = 0.5 * slope * way;
    pt::Vec3 p = well_inside(box), d = *direction();
    p[axis] = (out > 0 ? box.max[axis] : box.min[axis]) + (inwards ? -out : out) * beyond;
    d[axis] = 0;
    if (length(d) < 0.1) d[(axis + 1) % 3] = 1;
    d = normalize(d);
    d[axis] = inwards ? -out * slope : out * slope;
    return Case{box, {p - way * d, some_length(extreme) * d}};
  });
}

// A ray that starts outside a side of the box and goes away from it.
inline rc::Gen<Case> leaving(Extreme extreme = Extreme::none) {
  return rc::gen::exec([=] {
    const pt::Box box = some_box(extreme);
    const int axis = *whole(0, 2);
    const double out = sign();
    pt::Vec3 p = well_inside(box), d = some_direction(extreme);
    const double gap = std::max(*magnitude(1e-6, 3) * box.extent()[axis],
                                1e-10 * std::max(max_abs(box.min), max_abs(box.max)));
    p[axis] = (out > 0 ? box.max[axis] : box.min[axis]) + out * gap;
    d[axis] = out * std::abs(d[axis]);
    return Case{box, {p, d}};
  });
}

// A ray that starts inside the box, or on a side and goes inwards. The range may begin later.
inline rc::Gen<Case> starting_inside() {
  return rc::gen::exec([] {
    const pt::Box box = some_box();
    const int axis = *whole(0, 2);
    pt::Vec3 p = well_inside(box), d = some_direction();
    const int kind = *whole(0, 3);
    if (kind == 1 || kind == 2) {
      const bool upper = kind == 1;
      p[axis] = upper ? box.max[axis] : box.min[axis];
      d[axis] = (upper ? -1 : 1) * length(d) * *magnitude(1e-3, 1);
    }
    Case c{box, {p, d}};
    const long double leave = on_the_line(box, c.ray).leave.low;
    if (kind == 3) c.ray.t_min = *real(0.1, 0.9) * static_cast<double>(leave);
    return c;
  });
}

// One or two components of the direction are 0 or -0. The ray is inside the slabs of these axes or,
// if `beside` is true, outside one of them.
inline rc::Gen<Case> along_axes(bool beside) {
  return rc::gen::exec([=] {
    const pt::Box box = some_box();
    const int axis = *whole(0, 2), zeros = *whole(1, 2);
    pt::Vec3 target = well_inside(box);
    pt::Vec3 d{*real(0.1, 1), *real(0.1, 1), *real(0.1, 1)};
    for (int i = 0; i < 3; ++i) d[i] *= sign();
    for (int i = 0; i < zeros; ++i) d[(axis + i) % 3] = zero();
    if (beside) {
      const double gap = std::max(*magnitude(1e-6, 10) * length(box.extent()),
                                  1e-10 * std::max(max_abs(box.min), max_abs(box.max)));
      target[axis] = *whole(0, 1) == 0 ? box.min[axis] - gap : box.max[axis] + gap;
    }
    return Case{box, through(box, target, some_length() * d, *real(-0.1, 10))};
  });
}

// A box that is a sheet, and a ray that meets it from either side, at all angles. `thickness` is a
// part of its diagonal.
inline rc::Gen<Case> at_a_sheet(double thickness = 0) {
  return rc::gen::exec([=] {
    pt::Box box = some_box();
    const int axis = *whole(0, 2);
    box.max[axis] = box.min[axis] + thickness * length(box.extent());
    const pt::Vec3 target = well_inside(box);
    pt::Vec3 d{*real(-1, 1), *real(-1, 1), *real(-1, 1)};
    d[axis] = sign() * *magnitude(1e-3, 1);
    if (*whole(0, 2) == 0) d[(axis + 1) % 3] = zero();
    return Case{box, through(box, target, some_length() * d, *magnitude(1e-2, 100))};
  });
}

// A box that is a segment or a point. All coordinates are small whole numbers times a power of two,
// and t at the hit is a power of two, so that nothing is rounded.
inline rc::Gen<Case> at_a_segment() {
  return rc::gen::exec([] {
    const double scale = std::pow(2, *whole(-30, 30)), speed = std::pow(2, *whole(-9, 9));
    pt::Vec3 p{*whole(-9, 9) * 1.0, *whole(-9, 9) * 1.0, *whole(-9, 9) * 1.0}, d;
    for (int i = 0; i < 3; ++i) d[i] = *rc::gen::element(1.0, -1.0, 2.0, -2.0, 4.0, -4.0);
    pt::Box box{p, p};
    const int axis = *whole(0, 2), length = *whole(0, 3);
    box.min[axis] -= length;
    box.max[axis] += length;
    const pt::Vec3 origin = p - *rc::gen::element(1.0, 2.0, 8.0) * d;
    return Case{{scale * box.min, scale * box.max}, {scale * origin, speed * d}};
  });
}

inline double on_grid(double x) { return std::round(x * 0x1p20) * 0x1p-20; }

inline pt::Vec3 grid_point(double size) {
  return {on_grid(*real(-size, size)), on_grid(*real(-size, size)), on_grid(*real(-size, size))};
}

// A ray that grazes an edge or a corner of a triangle's box. All numbers are multiples of 2^-20. So
// target - origin is exact, and the ray is exactly at the target at t = 1. The box may be up to `away`
// from the world's origin, at most 2^30.
inline rc::Gen<Case> grazing(double away = 0) {
  return rc::gen::exec([=] {
    const pt::Vec3 shift = away > 0 ? grid_point(away) : pt::Vec3{};
    pt::Box box;
    for (int corner = 0; corner < 3; ++corner) box.grow(shift + grid_point(4));
    const int flat = *whole(0, 5);
    if (flat < 3) box.max[flat] = box.min[flat];
    const int along = *whole(0, 3);  // the edge's axis; 3 means a corner
    pt::Vec3 target;
    for (int i = 0; i < 3; ++i) target[i] = *rc::gen::element(box.min[i], box.max[i]);
    if (along < 3) target[along] = on_grid(box.center()[along]);
    const pt::Vec3 origin = shift + grid_point(15);
    return Case{box, {origin, target - origin}};
  });
}

}  // namespace grader::check::hit_box_cases
