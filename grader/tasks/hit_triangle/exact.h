#pragma once

#include "grader/tasks/hit_triangle/inputs.h"

#include <algorithm>
#include <array>
#include <vector>

// Triangles and rays of small whole numbers times a power of two, so that no method rounds the
// numbers that it compares: the normal of the plane has components that are zero or exactly equal,
// and weights are exactly zero.

namespace grader::check::hit_triangle_inputs {

// A normal that is an axis, at each corner. Two of them may be opposite, but their weighted sum is
// not zero.
inline std::array<pt::Vec3, 3> normals_along_the_axes(Weights w) {
  std::array<pt::Vec3, 3> normals;
  do {
    for (pt::Vec3& n : normals) {
      n = {};
      n[*whole(0, 2)] = *rc::gen::element(1.0, -1.0);
    }
  } while (w.b0 * normals[0] + w.b1 * normals[1] + w.b2 * normals[2] == pt::Vec3{});
  return normals;
}

inline pt::Triangle whole_triangle(Weights w) {
  const pt::Vec3 n = *whole_vector(1);
  const pt::Vec3 p0 = *whole(0, 3) == 0 ? pt::Vec3{} : *whole_vector(3);
  pt::Vec3 e1, e2;
  while (cross(e1, e2) == pt::Vec3{}) {
    e1 = cross(n, *whole_vector(2));
    e2 = cross(n, *whole_vector(2));
  }
  const double scale = *power_of_two(2);
  const auto [n0, n1, n2] = *whole(0, 1) == 0 ? normals_along_the_axes(w) : corner_normals();
  return {scale * p0, scale * (p0 + e1), scale * (p0 + e2), n0, n1, n2};
}

// A unit direction across the plane of the triangle, along an axis or between axes. Components that
// are zero may be almost zero instead.
inline pt::Vec3 direction_across(const pt::Triangle& triangle) {
  const pt::Vec3 face = geometric_normal(triangle);
  pt::Vec3 d;
  while (dot(d, face) == 0) d = *whole_vector(1);
  return with_other_zeros(normalize(d));
}

// One ray of four starts at the world's origin.
inline Aims exactly(Weights (*where)()) {
  return rc::gen::exec([=] {
    const Weights w = where();
    const pt::Triangle triangle = whole_triangle(w);
    const pt::Vec3 d = direction_across(triangle);
    Aimed made = aimed_along(triangle, w, d, *power_of_two(3));
    if (*whole(0, 3) > 0) return made;
    const pt::Vec3 o = made.ray.origin;
    for (pt::Vec3* p : {&made.triangle.p0, &made.triangle.p1, &made.triangle.p2}) *p -= o;
    made.ray.origin = {};
    return made;
  });
}

// The same ray, from exactly its point of the plane and with a range that begins later.
inline Aimed from_the_plane(Aimed aimed) {
  aimed.ray.origin = aimed.ray.at(aimed.t);
  aimed.ray.t_min = *rc::gen::element(1.0, 1e-3) * aimed.t;
  return aimed;
}

// Triangles without area, and rays in the plane of a triangle.

inline double small_whole() { return *whole(-2, 2); }

// Exchanges the axes in a cycle, so that `axis` becomes the third one.
inline pt::Vec3 turned(pt::Vec3 v, int axis) {
  return {v[(axis + 1) % 3], v[(axis + 2) % 3], v[axis]};
}

// Along the axes or diagonals: with these numbers, every method finds determinants that are exactly zero.
inline Aimed degenerate(const std::array<pt::Vec3, 3>& corners, pt::Vec3 start, pt::Vec3 d) {
  const double scale = *rc::gen::element(1.0, 0x1p-20, 0x1p20);
  const int axis = *whole(0, 2);
  const pt::Vec3 up = turned({0, 0, 1}, axis);
  const auto place = [&](pt::Vec3 v) { return scale * turned(v, axis); };
  return {{place(corners[0]), place(corners[1]), place(corners[2]), up, up, up},
          {place(start), place(d)}};
}

// Three corners on a line, of which two or all three may coincide. The ray is aimed at one of them.
inline Aims without_area() {
  return rc::gen::exec([] {
    const pt::Vec3 p{small_whole(), small_whole(), small_whole()}, along{1, 0, 0};
    std::array<pt::Vec3, 3> corners{p, p + small_whole() * along, p + small_whole() * along};
    std::rotate(corners.begin(), corners.begin() + *whole(0, 2), corners.end());
    const pt::Vec3 target = corners[*whole(0, 2)];
    pt::Vec3 d{};
    while (d == pt::Vec3{}) {
      d = {*whole(-1, 1) * 1.0, *whole(-1, 1) * 1.0, *whole(-1, 1) * 1.0};
    }
    return degenerate(corners, target - 2 * d, d);
  });
}

inline Aims in_the_plane() {
  return rc::gen::exec([] {
    const double height = small_whole();
    const pt::Vec3 p{small_whole(), small_whole(), height};
    const pt::Vec3 e1{1, small_whole(), 0}, e2{0, *rc::gen::element(2.0, -2.0), 0};
    pt::Vec3 d{};
    while (d == pt::Vec3{}) d = {*whole(-1, 1) * 1.0, *whole(-1, 1) * 1.0, 0};
    const pt::Vec3 towards = p + 0.5 * *whole(0, 1) * e1 + 0.5 * *whole(0, 1) * e2;
    return degenerate({p, p + e1, p + e2}, towards - *whole(0, 2) * d, d);
  });
}

// Rays at and close beside a line and a point, and rays in a triangle's plane or parallel to it.
inline std::vector<Aimed> fixed_degenerates() {
  constexpr pt::Vec3 kZ{0, 0, 1}, kDown{0, 0, -1}, kAlong{1, 0, 0};
  constexpr pt::Triangle kLine{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, kZ, kZ, kZ};
  constexpr pt::Triangle kDot{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}, kZ, kZ, kZ};
  constexpr pt::Triangle kFace{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, kZ, kZ, kZ};
  return {{kLine, {{1, 1, 3}, kDown}},     {kLine, {{1.2, 0.8, 3}, kDown}},
          {kDot, {{1, 1, 3}, kDown}},      {kDot, {{1.1, 1, 3}, kDown}},
          {kFace, {{-3, 0.5, 0}, kAlong}}, {kFace, {{0.5, 0.5, 0}, kAlong}},
          {kFace, {{0.5, 0.5, 1}, kAlong}}};
}

// The same with one number changed. The normals keep their length.
inline Aimed changed(Aimed aimed) {
  pt::Triangle& made = aimed.triangle;
  const double size = length(made.p1 - made.p0);
  make_one_of(joined({changes_of(made.p0, size), changes_of(made.p1, size),
                      changes_of(made.p2, size), changes_of(made.n0, 0.7), changes_of(made.n1, 0.7),
                      changes_of(made.n2, 0.7), changes_of(aimed.ray, size, aimed.t)}));
  for (pt::Vec3* n : {&made.n0, &made.n1, &made.n2}) *n = normalize(*n);
  return aimed;
}

// The same with two numbers exchanged, or with other corners or another ray, whose numbers have the same sum.
inline Aimed exchanged(Aimed aimed) {
  auto& [p0, p1, p2, n0, n1, n2] = aimed.triangle;
  switch (*whole(0, 2)) {
    case 0:
      exchange_or_add_in({&p0, &p1, &p2});
      break;
    case 1:
      exchange_in({&n0, &n1, &n2});
      break;
    default:
      exchange_or_add_in(aimed.ray);
  }
  return aimed;
}

}  // namespace grader::check::hit_triangle_inputs
