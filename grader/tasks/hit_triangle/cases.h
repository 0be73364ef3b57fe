#pragma once

#include "grader/property/generators.h"
#include "grader/property/show.h"
#include "pt/geometry/ray.h"
#include "pt/geometry/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>

// Triangles, and rays at known points of their planes.

namespace grader::hit_triangle_cases {

inline constexpr double kEpsilon = 0x1p-53;

struct Weights {
  double b0, b1, b2;  // sum to 1
};

// A triangle, and a ray at a known point of its plane.
struct Aimed {
  pt::Triangle triangle;
  pt::Ray ray;
  double t;
  pt::Vec3 n;        // the interpolated normal there
  double tolerance;  // of t: what rounding does to the plain determinants, some ten times over
};

inline void showValue(const Aimed& aimed, std::ostream& out) {
  show_lines(out, aimed.triangle, aimed.ray);
}

// How far the generator goes.
struct Range {
  double size_low = 1e-3, size_high = 1e3;  // of the first edge
  double thin = 1;                          // least height over length
  double far = 100;                         // largest distance, in sizes
  double tilt = 1.4;                        // from the plane's normal, radians
};

// Unit vectors within a radian of a common axis, which is on either side of the triangle; they
// never sum to almost nothing.
inline std::array<pt::Vec3, 3> corner_normals() {
  const pt::Frame around = *rotation();
  std::array<pt::Vec3, 3> normals;
  for (pt::Vec3& n : normals) {
    n = normalize(around.to_world({*real(-1, 1), *real(-1, 1), 1}));
  }
  return normals;
}

// Any rotation, or one whose z is so close to an axis that the other components are all but zero.
inline pt::Frame orientation() {
  if (*whole(0, 2) < 2) return *rotation();
  pt::Vec3 z;
  z[*whole(0, 2)] = *rc::gen::element(1.0, -1.0);
  return pt::frame_from_normal(normalize(z + *magnitude(1e-14, 1e-3) * *point(1)));
}

// The first edge has the length `size`; the third corner is at most one size along it and at least
// `thin` sizes away from it.
inline pt::Triangle triangle_of(double size, double thin) {
  const pt::Frame frame = orientation();
  const pt::Vec3 p0 = size * *point();
  const double along = *real(0, 1), height = *magnitude(thin, 1);
  const auto [n0, n1, n2] = corner_normals();
  return {p0, p0 + size * frame.x, p0 + size * (along * frame.x + height * frame.y), n0, n1, n2};
}

inline Aimed aimed_at(const pt::Triangle& triangle, Weights w, const Range& range) {
  const pt::Vec3 target = w.b0 * triangle.p0 + w.b1 * triangle.p1 + w.b2 * triangle.p2;
  const pt::Vec3 twice_area = geometric_normal(triangle);
  const pt::Frame plane = pt::frame_from_normal(normalize(twice_area));
  const double side = *rc::gen::element(1.0, -1.0);
  const double tilt = *real(-range.tilt, range.tilt), roll = *real(-pt::kPi, pt::kPi);
  const pt::Vec3 towards = plane.to_world(
      {std::sin(tilt) * std::cos(roll), std::sin(tilt) * std::sin(roll), side * std::cos(tilt)});
  const double size = length(triangle.p1 - triangle.p0);
  const double distance = size * *magnitude(1e-2, range.far);
  const double speed = *magnitude(1e-3, 1e3);
  const double height = length(twice_area) / size;
  const double error =
      64 * kEpsilon * (max_abs(target) + distance + size) * (size / height) / std::cos(tilt);
  const pt::Vec3 n = normalize(w.b0 * triangle.n0 + w.b1 * triangle.n1 + w.b2 * triangle.n2);
  return {
      triangle, {target - distance * towards, speed * towards}, distance / speed, n, error / speed};
}

// Well inside: no weight under 1/20.
inline Weights inside() {
  const double a = *real(0.05, 1), b = *real(0.05, 1), c = *real(0.05, 1);
  const double sum = a + b + c;
  return {0.9 * a / sum + 1.0 / 30, 0.9 * b / sum + 1.0 / 30, 0.9 * c / sum + 1.0 / 30};
}

inline rc::Gen<Aimed> aimed_inside(Range range = {}) {
  return rc::gen::exec([=] {
    const double size = *magnitude(range.size_low, range.size_high);
    const pt::Triangle triangle = triangle_of(size, range.thin < 1 ? range.thin : 0.5);
    return aimed_at(triangle, inside(), range);
  });
}

// At a point of the plane beyond one edge or two, by a thousandth of the triangle or by ten of it.
inline rc::Gen<Aimed> aimed_outside() {
  return rc::gen::exec([] {
    const double beyond = -*magnitude(1e-3, 10), other = *real(-3, 3);
    std::array<double, 3> b{beyond, other, 1 - beyond - other};
    std::rotate(b.begin(), b.begin() + *whole(0, 2), b.end());
    const double size = *magnitude(1e-3, 1e3);
    return aimed_at(triangle_of(size, 0.3), {b[0], b[1], b[2]}, {});
  });
}

inline double small_whole() { return *whole(-2, 2); }

// Corners, origin and direction are small whole numbers and the direction's quotients are exact, so
// that every determinant is zero to the last bit.
struct Degenerate {
  pt::Triangle triangle;
  pt::Ray ray;
};

inline void showValue(const Degenerate& c, std::ostream& out) {
  show_lines(out, c.triangle, c.ray);
}

inline const pt::Vec3 kUp{0, 0, 1};

inline bool divides_exactly(pt::Vec3 d) {
  const double largest = max_abs(d);
  return largest == 1 || largest == 2 || largest == 4;
}

inline rc::Gen<Degenerate> without_area() {
  return rc::gen::exec([] {
    const pt::Vec3 p{small_whole(), small_whole(), small_whole()};
    const pt::Vec3 step{1, small_whole(), small_whole()};
    std::array<pt::Vec3, 3> corners{p, p + small_whole() * step, p + small_whole() * step};
    std::rotate(corners.begin(), corners.begin() + *whole(0, 2), corners.end());
    const pt::Vec3 target = corners[*whole(0, 2)];
    const pt::Vec3 d{small_whole(), *rc::gen::element(1.0, -1.0, 2.0, -2.0), small_whole()};
    return Degenerate{{corners[0], corners[1], corners[2], kUp, kUp, kUp}, {target - 2 * d, d}};
  });
}

inline rc::Gen<Degenerate> in_the_plane() {
  return rc::gen::exec([] {
    const pt::Vec3 p{small_whole(), small_whole(), small_whole()};
    const pt::Vec3 e1{1, small_whole(), small_whole()}, e2{0, 2, small_whole()};
    const pt::Triangle triangle{p, p + e1, p + e2, kUp, kUp, kUp};
    const pt::Vec3 along = *rc::gen::element(e1, e2, -e1, -e2, e1 + e2, e1 - e2, e2 - e1);
    const pt::Vec3 d = divides_exactly(along) ? along : e2;
    const pt::Vec3 start = p + small_whole() * e1 + small_whole() * e2;
    return Degenerate{triangle, {start - 2 * d, d}};
  });
}

// A fan of four triangles around a corner that they share, and a ray at the corner or at one of the
// edges that two of them share, from in front.
struct Fan {
  std::array<pt::Triangle, 4> triangles;
  pt::Ray ray;
};

inline void showValue(const Fan& fan, std::ostream& out) {
  for (const pt::Triangle& triangle : fan.triangles) out << show(triangle) << "\n";
  out << show(fan.ray);
}

inline rc::Gen<Fan> aimed_between() {
  return rc::gen::exec([] {
    const pt::Vec3 middle = *point();
    const pt::Frame frame = *rotation();
    std::array<pt::Vec3, 4> rim;
    for (int i = 0; i < 4; ++i) {
      const double angle = 0.5 * pt::kPi * i + *real(-0.5, 0.5), radius = *magnitude(0.3, 3);
      rim[i] = middle + frame.to_world(
                            {radius * std::cos(angle), radius * std::sin(angle), *real(-0.2, 0.2)});
    }
    Fan fan;
    for (int i = 0; i < 4; ++i) fan.triangles[i] = flat_triangle(middle, rim[i], rim[(i + 1) % 4]);
    const double part = *rc::gen::element(0.0, 1.0) * *real(0, 0.9);
    const pt::Vec3 target = middle + part * (rim[0] - middle);
    const pt::Vec3 origin = target + frame.to_world({*real(-3, 3), *real(-3, 3), *real(5, 10)});
    fan.ray = {origin, target - origin};
    return fan;
  });
}

}  // namespace grader::hit_triangle_cases
