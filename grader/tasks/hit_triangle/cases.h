#pragma once

#include "grader/check/generators.h"
#include "grader/check/show.h"
#include "pt/geometry/ray.h"
#include "pt/geometry/triangle.h"
#include "pt/tasks/hit_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>

// Triangles, and rays that are aimed at known points of their planes.

namespace grader::check::hit_triangle_cases {

// The contract's precision of t, relative to the largest length in the case, and of n.
inline constexpr double kPrecision = 1e-9;
inline constexpr double kNormalPrecision = 1e-6;

struct Weights {
  double b0, b1, b2;  // sum to 1
};

// A triangle, and a ray that is aimed at a known point of its plane.
struct Aimed {
  pt::Triangle triangle;
  pt::Ray ray;
  double t;
  pt::Vec3 n;          // the interpolated normal there
  double tolerance;    // of t, by the contract
  double n_tolerance;  // of n, by the contract
};

inline void showValue(const Aimed& aimed, std::ostream& out) {
  show_lines(out, aimed.triangle, aimed.ray);
}

// The ranges of the generator's numbers. The defaults are ordinary, so that a mistake with extreme
// numbers breaks only the promises about extreme numbers.
struct Range {
  double size = 10;              // the first edge is from 1 / size to size long
  double speed = 1;              // the direction's length, likewise
  double thin = 0.5, thick = 1;  // the smallest and the largest height over length
  double away = 10;              // the largest coordinate, in sizes
  double near = 1e-2, far = 30;  // the distance, in sizes
  double flat = 0.17;            // the smallest angle between ray and plane, radians
  double steep = 0.5 * pt::kPi;  // the largest angle
  double tilt = 0;  // of the corner normals from a common axis, radians; 0: within a radian
};

// Unit vectors within a radian of a common axis, which may be on either side of the triangle. Some
// are much closer to each other, as in a fine mesh. With a tilt, they are half of it to all of it away
// from the axis, to any side. Their sum is never close to zero.
inline std::array<pt::Vec3, 3> corner_normals(double tilt = 0) {
  const pt::Frame around = *rotation();
  const double spread = *whole(0, 2) == 0 ? *magnitude(1e-5, 1) : 1;
  std::array<pt::Vec3, 3> normals;
  for (pt::Vec3& n : normals) {
    const double x = *real(-1, 1), y = *real(-1, 1);
    n = normalize(around.to_world({spread * x, spread * y, 1}));
    if (tilt == 0) continue;
    const double angle = tilt * (0.75 + 0.25 * x), azimuth = pt::kPi * y;
    n = around.to_world({std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth),
                         std::cos(angle)});
  }
  return normals;
}

// Any rotation, or one whose z is an axis, or so close to an axis that the other components are
// nearly zero.
inline pt::Frame orientation() {
  const int kind = *whole(0, 3);
  if (kind < 2) return *rotation();
  pt::Vec3 z;
  z[*whole(0, 2)] = *rc::gen::element(1.0, -1.0);
  if (kind == 2) return pt::frame_from_normal(z);
  return pt::frame_from_normal(normalize(z + *magnitude(1e-14, 1e-3) * *point(1)));
}

// The first edge has the length `size`; the third corner is at most one size along it and at least
// `thin` sizes away from it.
inline pt::Triangle triangle_of(const Range& range) {
  const double size = *magnitude(1 / range.size, range.size);
  const pt::Frame frame = orientation();
  const pt::Vec3 p0 = size * *point(range.away);
  const double along = *real(0, 1), height = *magnitude(range.thin, range.thick);
  const auto [n0, n1, n2] = corner_normals(range.tilt);
  return {p0, p0 + size * frame.x, p0 + size * (along * frame.x + height * frame.y), n0, n1, n2};
}

inline Aimed aimed_at(const pt::Triangle& triangle, Weights w, const Range& range) {
  const pt::Vec3 target = w.b0 * triangle.p0 + w.b1 * triangle.p1 + w.b2 * triangle.p2;
  const pt::Vec3 twice_area = geometric_normal(triangle);
  const pt::Frame plane = pt::frame_from_normal(normalize(twice_area));
  const double side = *rc::gen::element(1.0, -1.0);
  const double angle = *magnitude(range.flat, range.steep), roll = *real(-pt::kPi, pt::kPi);
  const double across = std::cos(angle);
  const pt::Vec3 towards =
      plane.to_world({across * std::cos(roll), across * std::sin(roll), side * std::sin(angle)});
  const double size = length(triangle.p1 - triangle.p0);
  const double distance = size * *magnitude(range.near, range.far);
  const double speed = *magnitude(1 / range.speed, range.speed);
  const double height = length(twice_area) / size;
  const double error = kPrecision * std::max({max_abs(target), distance, size}) *
                       std::max(1.0, size / height) / std::sin(angle);
  const pt::Vec3 mean = w.b0 * triangle.n0 + w.b1 * triangle.n1 + w.b2 * triangle.n2;
  // Normalising a short mean magnifies its errors.
  const double n_error = (kNormalPrecision + 10 * error / height) / std::min(1.0, 2 * length(mean));
  return {triangle,         {target - distance * towards, speed * towards},
          distance / speed, normalize(mean),
          error / speed,    n_error};
}

// Weights of a point well inside: none is below 1/20.
inline Weights inside() {
  const double a = *real(0.05, 1), b = *real(0.05, 1), c = *real(0.05, 1);
  const double sum = a + b + c;
  return {0.9 * a / sum + 1.0 / 30, 0.9 * b / sum + 1.0 / 30, 0.9 * c / sum + 1.0 / 30};
}

// Weights of a point inside, but close to an edge or, with two small weights, to a corner.
inline Weights just_inside() {
  const double small = *magnitude(2e-5, 1e-2), other = *real(0, 1) < 0.5 ? 0.4 : 2e-5;
  std::array<double, 3> b{small, other, 1 - small - other};
  std::rotate(b.begin(), b.begin() + *whole(0, 2), b.end());
  return {b[0], b[1], b[2]};
}

// Weights of a point beyond one or two edges, by 2e-5 to ten times the size of the triangle.
inline Weights outside() {
  const double beyond = -*magnitude(2e-5, 10), other = *real(-3, 3);
  std::array<double, 3> b{beyond, other, 1 - beyond - other};
  std::rotate(b.begin(), b.begin() + *whole(0, 2), b.end());
  return {b[0], b[1], b[2]};
}

// Weights of a point in the middle.
inline Weights in_the_middle() {
  const double a = *real(0.8, 1.2), b = *real(0.8, 1.2), c = *real(0.8, 1.2), sum = a + b + c;
  return {a / sum, b / sum, c / sum};
}

// Triangles ten times as long as high, met at little more than a millionth of a radian. Close to the
// origin and to the world's, the contract's precision is a seventh of the height.
inline constexpr Range kFlatNeedle{.thin = 0.1,
                                   .thick = 0.1,
                                   .away = 0.3,
                                   .near = 0.2,
                                   .far = 1,
                                   .flat = 1.05e-6,
                                   .steep = 1.5e-6};

// For points so close to an edge that only double precision sees on which side they are: cases in
// which the contract's precision is a hundred-millionth of the triangle.
inline constexpr Range kPrecise{.away = 1, .near = 0.5, .far = 2, .flat = 0.57};
// The same with corner normals that disagree by up to 160 degrees.
inline constexpr Range kDisagreeing{.away = 1, .near = 0.5, .far = 2, .flat = 0.57, .tilt = 1.4};

// Weights of a point at least four times as far from an edge as that, on either side of it.
inline Weights very_close(double side, double least = 1e-7, double most = 2e-5) {
  const double small = side * *magnitude(least, most), other = *real(0.1, 0.8);
  std::array<double, 3> b{small, other, 1 - small - other};
  std::rotate(b.begin(), b.begin() + *whole(0, 2), b.end());
  return {b[0], b[1], b[2]};
}
inline Weights barely_inside() { return very_close(1); }
inline Weights barely_outside() { return very_close(-1); }

// The best-shaped triangles, met steeply and from close by: the precision is 2.2e-9 of the triangle,
// and points are four to nine times as far from an edge.
inline constexpr Range kMostPrecise{.thin = 0.8, .away = 0.3, .near = 0.5, .far = 1, .flat = 1.2};
inline Weights a_hair_inside() { return very_close(1, 9e-9, 2e-8); }
inline Weights a_hair_outside() { return very_close(-1, 9e-9, 2e-8); }

// Needles as thin as the contract's example, for the smallest and the largest scale. The precision is
// an eighth of the distance from the edges.
inline constexpr Range kNeedle{
    .size = 1, .thin = 1e-3, .thick = 1e-3, .away = 1, .near = 0.5, .far = 2, .flat = 0.57};

inline rc::Gen<Aimed> aimed_inside(Range range = {}, Weights (*where)() = inside) {
  return rc::gen::exec([=] { return aimed_at(triangle_of(range), where(), range); });
}

// The same case, with all lengths multiplied. The direction keeps its length.
inline Aimed resized(Aimed aimed, double factor) {
  for (pt::Vec3* p :
       {&aimed.triangle.p0, &aimed.triangle.p1, &aimed.triangle.p2, &aimed.ray.origin}) {
    *p = factor * *p;
  }
  aimed.t *= factor;
  aimed.tolerance *= factor;
  return aimed;
}

// The same case with a longer or shorter direction. The range ends a little behind the point, and may
// begin a little before it.
inline Aimed scaled(Aimed aimed, double factor) {
  aimed.ray.direction *= factor;
  aimed.t /= factor;
  aimed.tolerance /= factor;
  aimed.ray.t_min = *rc::gen::element(0.0, 0.75) * aimed.t;
  aimed.ray.t_max = 1.5 * aimed.t;
  return aimed;
}

// Two rays at the plane of one triangle: one is aimed at a point outside the triangle, one at a
// point inside.
struct InAndOut {
  Aimed out, in;
};

inline void showValue(const InAndOut& both, std::ostream& out) { showValue(both.out, out); }

inline rc::Gen<InAndOut> aimed_outside(Range range = {}, Weights (*where)() = outside) {
  return rc::gen::exec([=] {
    const pt::Triangle triangle = triangle_of(range);
    const Aimed out = aimed_at(triangle, where(), range);
    return InAndOut{out, aimed_at(triangle, inside(), range)};
  });
}

// A fan of four triangles around a common corner, and a ray from the front. It is aimed at the
// corner or at an edge that two of the triangles share.
struct Fan {
  std::array<pt::Triangle, 4> triangles;
  pt::Ray ray;
};

inline void showValue(const Fan& fan, std::ostream& out) {
  for (const pt::Triangle& triangle : fan.triangles) out << show(triangle) << "\n";
  out << show(fan.ray);
}

inline bool is_hit(const Fan& fan) {
  return std::ranges::any_of(fan.triangles, [&](const pt::Triangle& triangle) {
    return pt::hit_triangle(triangle, fan.ray).has_value();
  });
}

// `away`: the largest coordinate of the corner.
inline rc::Gen<Fan> aimed_between(double away = 10) {
  return rc::gen::exec([=] {
    const pt::Vec3 middle = *point(away);
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

}  // namespace grader::check::hit_triangle_cases
