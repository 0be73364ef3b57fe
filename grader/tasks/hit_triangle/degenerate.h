#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/language/show.h"
#include "pt/geometry/ray.h"
#include "pt/geometry/triangle.h"

#include <algorithm>
#include <array>
#include <vector>

// Triangles without area, and rays in the plane of a triangle.

namespace grader::check::hit_triangle_inputs {

inline double small_whole() { return *whole(-2, 2); }

// A triangle and a ray made of small whole numbers times a power of two, along the axes or
// diagonals. With these numbers, every method finds determinants that are exactly zero.
struct Degenerate {
  pt::Triangle triangle;
  pt::Ray ray;
};

inline void showValue(const Degenerate& c, std::ostream& out) {
  show_lines(out, c.triangle, c.ray);
}

// Exchanges the axes in a cycle, so that `axis` becomes the third one.
inline pt::Vec3 turned(pt::Vec3 v, int axis) {
  return {v[(axis + 1) % 3], v[(axis + 2) % 3], v[axis]};
}

inline Degenerate degenerate(const std::array<pt::Vec3, 3>& corners, pt::Vec3 start, pt::Vec3 d) {
  const double scale = *rc::gen::element(1.0, 0x1p-20, 0x1p20);
  const int axis = *whole(0, 2);
  const pt::Vec3 up = turned({0, 0, 1}, axis);
  const auto place = [&](pt::Vec3 v) { return scale * turned(v, axis); };
  return {{place(corners[0]), place(corners[1]), place(corners[2]), up, up, up},
          {place(start), place(d)}};
}

// Three corners on a line, of which two or all three may coincide. The ray is aimed at one of them.
inline rc::Gen<Degenerate> without_area() {
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

inline rc::Gen<Degenerate> in_the_plane() {
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
inline std::vector<Degenerate> fixed_degenerates() {
  constexpr pt::Vec3 kZ{0, 0, 1}, kDown{0, 0, -1}, kAlong{1, 0, 0};
  constexpr pt::Triangle kLine{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, kZ, kZ, kZ};
  constexpr pt::Triangle kDot{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}, kZ, kZ, kZ};
  constexpr pt::Triangle kFlat{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, kZ, kZ, kZ};
  return {{kLine, {{1, 1, 3}, kDown}},     {kLine, {{1.2, 0.8, 3}, kDown}},
          {kDot, {{1, 1, 3}, kDown}},      {kDot, {{1.1, 1, 3}, kDown}},
          {kFlat, {{-3, 0.5, 0}, kAlong}}, {kFlat, {{0.5, 0.5, 0}, kAlong}},
          {kFlat, {{0.5, 0.5, 1}, kAlong}}};
}

}  // namespace grader::check::hit_triangle_inputs
