#pragma once

#include "grader/tasks/hit_triangle/inputs.h"

#include <array>

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
inline rc::Gen<Aimed> exactly(Weights (*where)()) {
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
