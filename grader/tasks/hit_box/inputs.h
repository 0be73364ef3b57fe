#pragma once

#include "grader/check/language/cases.h"
#include "grader/tasks/hit_box/boxes.h"
#include "grader/tasks/hit_box/truth.h"
#include "pt/tasks/hit_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// Boxes, and rays that are known to meet or to miss them.

namespace grader::check::hit_box_inputs {

struct Case {
  pt::Box box;
  pt::Ray ray;
};

inline void showValue(const Case& c, std::ostream& out) { show_lines(out, c.box, c.ray); }

using Boxes = Cases<Case>;

inline auto call(const Case& c) { return pt::hit_box(c.box, c.ray); }
inline Part expected(const Case& c, double precision = kPrecision) {
  return expected(c.box, c.ray, precision);
}

// The distance from a ray's origin to its target, in sizes of the box. Half of the extreme ones are
// so large that the squares of distances, in double, say nothing about the box.
inline double some_distance(Extreme extreme = Extreme::none) {
  if (extreme != Extreme::distance && extreme != Extreme::all) return *magnitude(1e-2, 100);
  return *rc::gen::oneOf(magnitude(100, 1e7), magnitude(1e7, 1e9));
}

inline Boxes aimed_inside(Extreme extreme = Extreme::none) {
  return rc::gen::exec([=] {
    const pt::Box box = some_box(extreme);
    return Case{box,
                through(box, well_inside(box), some_direction(extreme), some_distance(extreme))};
  });
}

// A ray at a point of a side that faces it, at steep and flat angles.
inline Boxes aimed_at_a_side(Extreme extreme = Extreme::none) {
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
inline Boxes passing(Extreme extreme = Extreme::none) {
  return rc::gen::exec([=] {
    const pt::Box box = some_box(extreme);
    const int i = *whole(0, 2), j = (i + *whole(1, 2)) % 3, k = 3 - i - j;
    const double out_i = sign(), out_j = sign();
    const double angle = *real(0.02, pt::kPi / 2 - 0.02);
    const bool far = extreme == Extreme::distance || extreme == Extreme::all;
    const double before = far ? some_distance(extreme) : *magnitude(1e-2, 30);
    const double size = length(box.extent());
    const double least = 1e-10 * (max_abs(box.center()) + before * size);
    const double gap = std::max(*magnitude(1e-6, 3) * size, least);
    pt::Vec3 p = well_inside(box), d;
    p = beyond(box, p, i, out_i, gap * std::cos(angle));
    p = beyond(box, p, j, out_j, gap * std::sin(angle));
    d[i] = -out_i * std::sin(angle);
    d[j] = out_j * std::cos(angle);
    d[k] = *real(-1, 1);
    return Case{box, through(box, p, sign() * some_length(extreme) * d, before)};
  });
}

// A ray that is almost parallel to a side and crosses its plane half way to the box. `slope` is the
// component of its direction that points out of this side. The ray meets the box if it is negative.
inline Case crossing_at(const pt::Box& box, pt::Vec3 p, pt::Vec3 d, int axis, double out,
                        double slope, double way) {
  d[axis] = out * slope;
  return {box, ray_to(beyond(box, p, axis, out, 0.5 * slope * way), d, way)};
}

// The same, inwards or outwards. On the way the ray moves only some 1e-11 to 1e-5 of the way
// across, which is ten times the contract's precision or more.
inline Boxes crossing_on_the_way(bool inwards, Extreme extreme = Extreme::none) {
  return rc::gen::exec([=] {
    const pt::Box box = some_box();
    const int axis = *whole(0, 2);
    const double out = sign();
    const double way = *magnitude(10, 1e4) * std::max(length(box.extent()), size_of(box, {}));
    const double slope = std::min(*magnitude(2e-11, 1e-5), 0.8 * box.extent()[axis] / way);
    pt::Vec3 p = well_inside(box), d = *direction();
    d[axis] = 0;
    if (length(d) < 0.1) d[(axis + 1) % 3] = 1;
    Case c = crossing_at(box, p, normalize(d), axis, out, inwards ? -slope : slope, way);
    c.ray.direction *= some_length(extreme);
    return c;
  });
}

// A ray that starts behind the box, or whose range ends before the box or begins behind it.
inline Case out_of_range(Case c) {
  const Part line = on_the_line(c.box, c.ray);
  const double enter = rounded(line.enter.low), leave = rounded(line.leave.high);
  const double part = *rc::gen::element(0.5, 0.05, 1e-3, 1e-6);
  const int kind = *whole(0, 2);
  if (kind == 0) c.ray.t_min = leave * (1 + part);
  if (kind == 1 && enter > 0) c.ray.t_max = enter * (1 - part);
  // For an origin inside the box, t = 0 is inside it too, and no range can end before the box.
  // This ray starts behind the box instead.
  if (kind == 2 || (kind == 1 && !(enter > 0))) {
    c.ray = {c.ray.at(leave + part * (leave - enter)), c.ray.direction};
  }
  return c;
}

// The same ray with a range inside the box: `first` and `last` are parts of the way through it.
inline Case cut_inside(Case c, double first, double last) {
  const Part part = expected(c);
  const double enter = rounded(part.enter.high), way = rounded(part.leave.low) - enter;
  c.ray.t_min = enter + first * way;
  c.ray.t_max = enter + last * way;
  return c;
}

// A ray that starts outside a side of the box and goes away from it.
inline Boxes leaving(Extreme extreme = Extreme::none) {
  return rc::gen::exec([=] {
    const pt::Box box = some_box(extreme);
    const int axis = *whole(0, 2);
    const double out = sign();
    pt::Vec3 p = well_inside(box), d = some_direction(extreme);
    const double gap = std::max(*magnitude(1e-6, 3) * box.extent()[axis],
                                1e-10 * std::max(max_abs(box.min), max_abs(box.max)));
    d[axis] = out * std::abs(d[axis]);
    return Case{box, {beyond(box, p, axis, out, gap), d}};
  });
}

// A ray that starts inside the box, or on a side and goes inwards. The range may begin later, or be
// the start alone.
inline Boxes starting_inside() {
  return rc::gen::exec([] {
    const pt::Box box = some_box();
    const int axis = *whole(0, 2);
    pt::Vec3 p = well_inside(box), d = some_direction();
    const int kind = *whole(0, 4);
    if (kind == 1 || kind == 2) {
      const bool upper = kind == 1;
      p[axis] = upper ? box.max[axis] : box.min[axis];
      d[axis] = (upper ? -1 : 1) * length(d) * *magnitude(1e-3, 1);
    }
    Case c{box, {p, d}};
    const double leave = rounded(on_the_line(box, c.ray).leave.low);
    if (kind == 3) c.ray.t_min = *real(0.1, 0.9) * leave;
    if (kind == 4) c.ray.t_max = 0;
    return c;
  });
}

// One or two components of the direction are 0 or -0. The ray is inside the slabs of these axes or,
// if `beside` is true, outside one of them.
inline Boxes along_axes(bool beside) {
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
      target = beyond(box, target, axis, *whole(0, 1) == 0 ? -1 : 1, gap);
    }
    return Case{box, through(box, target, some_length() * d, *real(-0.1, 10))};
  });
}

// A box that is a sheet, and a ray that meets it from either side, at all angles. `thickness` is a
// part of its diagonal.
inline Boxes at_a_sheet(double thickness = 0) {
  return rc::gen::exec([=] {
    const pt::Box any = some_box();
    const int axis = *whole(0, 2);
    const pt::Box box = flattened(any, axis, thickness);
    const pt::Vec3 target = well_inside(box);
    pt::Vec3 d{*real(-1, 1), *real(-1, 1), *real(-1, 1)};
    d[axis] = sign() * *magnitude(1e-3, 1);
    if (*whole(0, 2) == 0) d[(axis + 1) % 3] = zero();
    return Case{box, through(box, target, some_length() * d, *magnitude(1e-2, 100))};
  });
}

// A ray that starts exactly in the plane of a sheet and leaves it: from the sheet itself, or from beside
// it and towards it. Often this is a plane of the world's axes.
inline Boxes from_the_plane_of_a_sheet(bool beside) {
  return rc::gen::exec([=] {
    pt::Box box = some_box();
    const int axis = *whole(0, 2), other = (axis + *whole(1, 2)) % 3;
    if (*whole(0, 1) == 0) box.min[axis] = 0;
    box = flattened(box, axis);
    const double out = sign();
    pt::Vec3 origin = well_inside(box), d{*real(-1, 1), *real(-1, 1), *real(-1, 1)};
    d[axis] = sign() * *real(0.1, 1);
    if (beside) {
      origin = beyond(box, origin, other, out, *magnitude(1e-3, 3) * length(box.extent()));
      d[other] = -out * *real(0.1, 1);
    }
    return Case{box, {origin, some_length() * d}};
  });
}

// A box that is a segment of this half length around the target, or a point.
inline Case segment_at(pt::Vec3 target, int axis, double half, pt::Vec3 d, double before) {
  pt::Box box{target, target};
  box.min[axis] -= half;
  box.max[axis] += half;
  return {box, ray_to(target, d, before)};
}

// The same with one number changed.
inline Case changed(Case c) {
  const double size = length(c.box.extent());
  const Part part = on_the_line(c.box, c.ray);
  const double inside = std::max(rounded(part.leave.low), 0.0);
  make_one_of(joined({changes_of(c.box.min, -size), changes_of(c.box.max, size),
                      changes_of(c.ray, size, inside)}));
  return c;
}

// The same with two numbers of the box, or of the ray, exchanged, or with other numbers of the same sum.
inline Case exchanged(Case c) {
  if (*whole(0, 1) == 0) {
    exchange_or_add_in(c.box);
  } else {
    exchange_or_add_in(c.ray);
  }
  return c;
}

// The following cases are of a fixed stream of random numbers.

// A ray that is at a point inside at t = `way`.
inline Case at_a_box(RandomNumbers& make, const pt::Box& box, pt::Vec3 d, double way) {
  return {box, ray_to(inside(box, make), d, way)};
}

// A ray from any side, at a point that is up to `beside` widths from a point inside.
inline Case from_anywhere(RandomNumbers& make, double size, double beside) {
  const pt::Box box = some_box(make, size);
  const double width = max_abs(box.extent());
  const pt::Vec3 origin = box.center() + 4 * width * normalize(make.vector(-1, 1));
  const pt::Vec3 target = inside(box, make), shift = beside * width * make.vector(-1, 1);
  return {box, {origin, make.between(0.1, 2) * (target + shift - origin)}};
}

// A ray beside a side of the box, forwards (1) or backwards (-1) on its line. For some t it is
// inside the other two slabs.
inline Case beside_a_side(const pt::Box& box, int axis, double side, double forwards) {
  pt::Vec3 d;
  d[axis] = 0.05;
  d[(axis + 1) % 3] = 1;
  d[(axis + 2) % 3] = 0.5 * side;
  const pt::Vec3 target = beyond(box, box.center(), axis, side, 0.7 * box.extent()[axis]);
  return {box, ray_to(target, forwards * d, 7)};
}

// A ray through the centre of a box. Its range counts in units of the box: 1 is where the ray
// enters it, 2 where it leaves it. Where `low` is negative, the box is behind the ray instead.
inline Case in_a_range(RandomNumbers& make, double low, double high, double speed) {
  constexpr double kWay = 5;
  const pt::Box box = some_box(make, 1);
  const pt::Vec3 along = normalize(make.vector(-1, 1) + pt::Vec3{0.2, 0.1, 0.3});
  if (low < 0) return {box, {box.center() + kWay * along, speed * along}};
  double half = pt::kInfinity;
  for (int axis = 0; axis < 3; ++axis) {
    half = std::min(half, box.extent()[axis] / 2 / std::abs(along[axis]));
  }
  const auto t_at = [&](double place) {
    return std::max(0.0, kWay + half * (2 * place - 3)) / speed;
  };
  return {box, {box.center() - kWay * along, speed * along, t_at(low), t_at(high)}};
}

// The ranges of in_a_range.
inline constexpr std::array<double, 2> kRanges[] = {{0, .5},   {.5, 1.5},  {1.2, 1.8}, {1.5, 9},
                                                    {2.5, 9},  {0, 9},     {-9, -1},   {1.2, 9},
                                                    {.5, 2.5}, {2.2, 2.5}, {.2, .7}};

// Three rays along an axis, at the box and beside it, and two rays with only this component zero.
// `zero` is 0 or -0.
inline std::vector<Case> along_an_axis(RandomNumbers& make, int axis, double sign, double zero) {
  const pt::Box box = some_box(make, 1);
  const pt::Vec3 p = inside(box, make);
  pt::Vec3 d{zero, zero, zero}, slanted{0.7, -0.4, 0.5};
  d[axis] = sign;
  slanted[axis] = zero;
  return {{box, ray_to(p, d, 6)},
          {box, ray_to(beyond(box, p, (axis + 1) % 3, 1, 0.5), d, 6)},
          {box, ray_to(beyond(box, p, (axis + 2) % 3, -1, 0.5), d, 6)},
          {box, ray_to(p, slanted, 5)},
          {box, ray_to(beyond(box, p, axis, 1, 0.3), slanted, 5)}};
}

// A ray that enters a box through its lower side in x, at t.
inline Case at_the_first_side(RandomNumbers& make, double t) {
  const pt::Box box = some_box(make, 1);
  const pt::Vec3 target = beyond(box, inside(box, make), 0, -1, 0);
  return {box, ray_to(target, normalize(pt::Vec3{1, 0.3, -0.2} + 0.1 * make.vector(-1, 1)), t)};
}

// A ray past an edge of a box, along a line that has the whole box on one side.
inline Case past_an_edge(RandomNumbers& make, int axis, double way) {
  const pt::Box box = some_box(make, 1);
  const int other = (axis + 1) % 3;
  pt::Vec3 d{0.3, 0.3, 0.3};
  d[axis] = 0.7;
  d[other] = -0.7;
  const pt::Vec3 beside = beyond(box, box.center(), axis, 1, 0.1);
  return {box, ray_to(beyond(box, beside, other, 1, 0.1), d, way)};
}

}  // namespace grader::check::hit_box_inputs
