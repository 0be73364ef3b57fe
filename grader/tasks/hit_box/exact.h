#pragma once

#include "grader/tasks/hit_box/inputs.h"

#include <array>
#include <cmath>
#include <utility>

// Boxes and rays whose numbers no method has to round: rays that start exactly on a side, meet several
// sides at one t, end exactly where they enter, or graze an edge.

namespace grader::check::hit_box_inputs {

// A box that is a segment or a point. All coordinates are small whole numbers times a power of two,
// and t at the hit is a power of two, so that nothing is rounded.
inline Boxes at_a_segment() {
  return rc::gen::exec([] {
    const double scale = std::pow(2, *whole(-30, 30)), speed = std::pow(2, *whole(-9, 9));
    pt::Vec3 p{*whole(-9, 9) * 1.0, *whole(-9, 9) * 1.0, *whole(-9, 9) * 1.0}, d;
    for (int i = 0; i < 3; ++i) d[i] = *rc::gen::element(1.0, -1.0, 2.0, -2.0, 4.0, -4.0);
    const int axis = *whole(0, 2), half = *whole(0, 3);
    const auto [box, ray] = segment_at(p, axis, half, d, *rc::gen::element(1.0, 2.0, 8.0));
    return Case{{scale * box.min, scale * box.max}, {scale * ray.origin, speed * ray.direction}};
  });
}

// A box and a ray of small whole numbers times powers of two, so that no method has to round. At
// t = `way` the ray is, on each axis, in the middle of the box (0), on its lower side (-1) or on its
// upper side (1), and it is never parallel to a side that it is on. A ray through the middle of a
// cube meets all sides that it enters at the same t. Often a corner of the box or the ray's origin is
// the world's origin.
inline Case whole_case(const std::array<int, 3>& places, double way) {
  const double scale = *power_of_two(3), speed = *power_of_two(2);
  const double width = *power_of_two(1), slope = *power_of_two(1);
  const bool cube = *whole(0, 1) == 0;
  const int at_zero = *whole(0, 3);
  const pt::Vec3 low = at_zero == 0 ? pt::Vec3{} : *whole_vector(4);
  pt::Vec3 size, target, d;
  for (int axis = 0; axis < 3; ++axis) {
    size[axis] = 2 * (cube ? width : *power_of_two(1));
    target[axis] = low[axis] + 0.5 * (1 + places[axis]) * size[axis];
    const bool still = places[axis] == 0 && *whole(0, 2) == 0;
    d[axis] = still ? 0 : sign() * (cube ? slope : *power_of_two(1));
  }
  if (d == pt::Vec3{}) d[*whole(0, 2)] = sign();
  const Case made{{scale * low, scale * (low + size)},
                  ray_to(scale * target, speed * with_other_zeros(d), scale / speed * way)};
  if (at_zero != 1) return made;
  const pt::Vec3 o = made.ray.origin;
  return {{made.box.min - o, made.box.max - o}, {{}, made.ray.direction}};
}

inline Boxes through_the_middle(double way) {
  return rc::gen::exec([=] { return whole_case({0, 0, 0}, way); });
}

// The ray starts exactly on a side, an edge or, in half of the cases, a corner, and goes in or out. Its
// range may begin later, and it may be the start alone.
inline Boxes from_a_side() {
  return rc::gen::exec([] {
    const bool corner = *whole(0, 1) == 0, inwards = *whole(0, 3) > 0;
    std::array<int, 3> places{};
    while (places == std::array<int, 3>{}) {
      for (int& place : places) place = corner ? *rc::gen::element(-1, 1) : *whole(-1, 1);
    }
    Case c = whole_case(places, 0);
    for (int axis = 0; inwards && axis < 3; ++axis) {
      double& d = c.ray.direction[axis];
      if (places[axis] != 0) d = std::copysign(d, -places[axis]);
    }
    const double leave = rounded(on_the_line(c.box, c.ray, 0).leave.low);
    const int kind = *whole(0, 3);
    if (kind == 0) c.ray.t_max = 0;
    if (kind >= 2 && leave > 0) c.ray.t_min = leave * *rc::gen::element(0.25, 0.5, 1.0);
    return c;
  });
}

// A ray exactly in the plane of a side or along an edge, from inside the box or in front of it. The
// box may be flat, a segment or a point.
inline Boxes in_planes() {
  return rc::gen::exec([] {
    const double scale = *power_of_two(3), speed = *power_of_two(2);
    const int still = *whole(0, 2), moving = (still + *whole(1, 2)) % 3;
    pt::Vec3 low = *whole_vector(4), size, target, d;
    for (int axis = 0; axis < 3; ++axis) {
      const bool moves = axis == moving || (axis != still && *whole(0, 1) == 0);
      size[axis] = *whole(0, 2) == 0 ? 0 : 2 * *power_of_two(1);
      target[axis] = low[axis] + (moves ? 0.5 : *rc::gen::element(0.0, 1.0)) * size[axis];
      d[axis] = moves ? sign() * *power_of_two(1) : *rc::gen::element(0.0, -0.0);
    }
    return Case{
        {scale * low, scale * (low + size)},
        ray_to(scale * target, speed * d, scale / speed * *rc::gen::element(0.0, 1.0, 8.0))};
  });
}

// The ray's range ends exactly where it enters the box, begins exactly where it leaves it, or both.
inline Boxes touching_the_range() {
  return rc::gen::exec([] {
    Case c = whole_case({0, 0, 0}, 8);
    const Part part = on_the_line(c.box, c.ray, 0);
    const int kind = *whole(0, 3);
    const double t = rounded(kind < 2 ? part.enter.low : part.leave.low);
    if (kind != 2) c.ray.t_max = t;
    if (kind != 0) c.ray.t_min = t;
    return c;
  });
}

inline double on_grid(double x) { return std::round(x * 0x1p20) * 0x1p-20; }

inline pt::Vec3 grid_point(double size) {
  return {on_grid(*real(-size, size)), on_grid(*real(-size, size)), on_grid(*real(-size, size))};
}

// A ray that grazes an edge or a corner of a triangle's box. All numbers are multiples of 2^-20. So
// target - origin is exact, and the ray is exactly at the target at t = 1. The box may be up to
// `away` from the world's origin, at most 2^30.
inline Boxes grazing(double away = 0) {
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

// A ray that meets two planes at exactly the same t: it enters the box through the one and leaves
// it through the other. No number is rounded, but each difference, quotient and product of the slab
// method is. Of twenty rays, this is the one whose rounding errors separate the planes most. The numbers
// of each axis are of a size of their own: one axis says nothing about the rounding errors of another.
inline Boxes separated_by_rounding() {
  return rc::gen::exec([] {
    struct Crossing {
      double origin, plane, speed;
      double t() const { return (plane - origin) * (1 / speed); }
    };
    const auto crossing_at = [](double t) {
      const double speed = std::floor(*real(0x1p30, 0x1p40));
      const long double way = static_cast<long double>(speed) * t;  // an integer below 2^60
      const auto plane = static_cast<double>(0x1p12L * std::ceil(way / 0x1p12L));
      const auto origin = static_cast<double>(plane - way);
      // Either the plane or the origin is far from zero.
      return *whole(0, 1) == 0 ? Crossing{origin, plane, speed} : Crossing{-plane, -origin, speed};
    };
    Crossing in{}, out{};
    double apart = -1;
    for (int i = 0; i < 20; ++i) {
      const double t = std::floor(*real(0x1p19, 0x1p20));
      const Crossing a = crossing_at(t), b = crossing_at(t);
      if (a.t() / b.t() - 1 <= apart) continue;
      apart = a.t() / b.t() - 1;
      in = a;
      out = b;
    }
    const int first = *whole(0, 2), second = (first + *whole(1, 2)) % 3;
    Case c{{{-0x1p21, -0x1p21, -0x1p21}, {0x1p21, 0x1p21, 0x1p21}},
           {{}, {*real(-1, 1), *real(-1, 1), *real(-1, 1)}}};
    for (const auto& [axis, crossing] : {std::pair{first, in}, std::pair{second, out}}) {
      const double unit = sign() * 0x1p-58 * *power_of_two(20);
      const double width = 0x1p12 * std::floor(*magnitude(1, 0x1p56));
      c.ray.origin[axis] = unit * crossing.origin;
      c.ray.direction[axis] = unit * crossing.speed;
      const bool at_min = (axis == first) == (unit > 0);
      (at_min ? c.box.min : c.box.max)[axis] = unit * crossing.plane;
      (at_min ? c.box.max : c.box.min)[axis] =
          unit * (crossing.plane + (axis == first ? width : -width));
    }
    return c;
  });
}

}  // namespace grader::check::hit_box_inputs
