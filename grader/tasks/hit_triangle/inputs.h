#pragma once

#include "grader/check/generators/generators.h"
#include "grader/check/generators/special.h"
#include "grader/check/language/cases.h"
#include "grader/tasks/hit_triangle/truth.h"
#include "grader/tasks/hit_triangle/weights.h"
#include "pt/tasks/hit_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>

// Triangles, and rays that are aimed at known points of their planes.

namespace grader::check::hit_triangle_inputs {

// The contract's precision of t, relative to the largest length in the case, and of n.
inline constexpr double kPrecision = 1e-9;
inline constexpr double kNormalPrecision = 1e-6;

// A triangle, and a ray that is aimed at a known point of its plane. A triangle without area and a ray
// in the plane have no such point.
struct Aimed {
  pt::Triangle triangle;
  pt::Ray ray;
  double t = 0;
  pt::Vec3 n{};            // the interpolated normal there
  double tolerance = 0;    // of t, by the contract
  double n_tolerance = 0;  // of n, by the contract

  // The ray that is at the same point at the same t, and comes from the other side.
  Aimed from_the_other_side() const {
    Aimed other = *this;
    other.ray.origin = ray.at(2 * t);
    other.ray.direction = -ray.direction;
    return other;
  }
};

inline void showValue(const Aimed& aimed, std::ostream& out) {
  show_lines(out, aimed.triangle, aimed.ray);
}

using Aims = Cases<Aimed>;

inline auto call(const Aimed& aimed) { return pt::hit_triangle(aimed.triangle, aimed.ray); }

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

// A unit vector towards the point (x, y, 1) of the frame.
inline pt::Vec3 normal_at(const pt::Frame& around, double x, double y) {
  return normalize(around.to_world({x, y, 1}));
}

// Unit vectors within a radian of a common axis, which may be on either side of the triangle. Some
// are much closer to each other, as in a fine mesh. With a tilt, they are half of it to all of it
// away from the axis, to any side. Their sum is never close to zero.
inline std::array<pt::Vec3, 3> corner_normals(double tilt = 0) {
  const pt::Frame around = *rotation();
  const double spread = *whole(0, 2) == 0 ? *magnitude(1e-5, 1) : 1;
  std::array<pt::Vec3, 3> normals;
  for (pt::Vec3& n : normals) {
    const double x = *real(-1, 1), y = *real(-1, 1);
    n = normal_at(around, spread * x, spread * y);
    if (tilt == 0) continue;
    const double angle = tilt * (0.75 + 0.25 * x), azimuth = pt::kPi * y;
    n = around.to_world({std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth),
                         std::cos(angle)});
  }
  return normals;
}

// The first edge has the length `size` and the direction of the frame's x. The third corner is
// `along` sizes along this edge and `height` sizes away from it.
inline pt::Triangle triangle_at(pt::Vec3 p0, const pt::Frame& frame, double size, double along,
                                double height, const std::array<pt::Vec3, 3>& normals) {
  const auto& [n0, n1, n2] = normals;
  return {p0, p0 + size * frame.x, p0 + size * (along * frame.x + height * frame.y), n0, n1, n2};
}

// The third corner is at most one size along the first edge and at least `thin` sizes away from it.
inline pt::Triangle triangle_of(const Range& range) {
  const double size = *magnitude(1 / range.size, range.size);
  const pt::Frame frame = *any_frame();
  const pt::Vec3 p0 = size * *point(range.away);
  const double along = *real(0, 1), height = *magnitude(range.thin, range.thick);
  return triangle_at(p0, frame, size, along, height, corner_normals(range.tilt));
}

// A frame whose z is the normal of the triangle's plane.
inline pt::Frame plane_of(const pt::Triangle& triangle) {
  return pt::frame_from_normal(normalize(geometric_normal(triangle)));
}

// The ray is at the point of these weights at t.
inline Aimed aimed_along(const pt::Triangle& triangle, Weights w, pt::Vec3 direction, double t) {
  const pt::Vec3 target = w.b0 * triangle.p0 + w.b1 * triangle.p1 + w.b2 * triangle.p2;
  const pt::Vec3 face = geometric_normal(triangle);
  const double size = length(triangle.p1 - triangle.p0), speed = length(direction);
  const double height = length(face) / size, distance = t * speed;
  const double sine = std::abs(dot(face, direction)) / (length(face) * speed);
  const double error = kPrecision * std::max({max_abs(target), distance, size}) *
                       std::max(1.0, size / height) / sine;
  const pt::Vec3 mean = w.b0 * triangle.n0 + w.b1 * triangle.n1 + w.b2 * triangle.n2;
  // Normalising a short mean magnifies its errors.
  const double n_error = (kNormalPrecision + 10 * error / height) / std::min(1.0, 2 * length(mean));
  return {triangle, {target - t * direction, direction}, t, normalize(mean), error / speed,
          n_error};
}

// `local` is the ray's unit direction in the frame of the triangle's plane.
inline Aimed aimed_at(const pt::Triangle& triangle, Weights w, pt::Vec3 local, double distance,
                      double speed) {
  return aimed_along(triangle, w, speed * plane_of(triangle).to_world(local), distance / speed);
}

inline Aimed aimed_at(const pt::Triangle& triangle, Weights w, const Range& range) {
  const double side = *rc::gen::element(1.0, -1.0);
  const double angle = *magnitude(range.flat, range.steep), roll = *real(-pt::kPi, pt::kPi);
  const double across = std::cos(angle);
  const pt::Vec3 local{across * std::cos(roll), across * std::sin(roll), side * std::sin(angle)};
  const double size = length(triangle.p1 - triangle.p0);
  const double distance = size * *magnitude(range.near, range.far);
  const double speed = *magnitude(1 / range.speed, range.speed);
  return aimed_at(triangle, w, local, distance, speed);
}

// Rays that meet the plane at a millionth of a radian to ten degrees.
inline constexpr Range kFlat{.away = 1, .near = 0.1, .far = 3, .flat = 1e-6, .steep = 0.17};
inline constexpr Range kFlattest{.away = 1, .near = 0.1, .far = 3, .flat = 1e-6, .steep = 2e-6};

// Triangles ten times as long as high, met at little more than a millionth of a radian. Close to
// the origin and to the world's, the contract's precision is a seventh of the height.
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

// A thousand times as long as high, and met so flatly that the determinant is a twenty-millionth of the product of the lengths. In the middle, the
// precision is a fiftieth of the height.
inline constexpr Range kFlatSliver{
    .thin = 1e-3, .thick = 1e-3, .away = 0.3, .near = 0.2, .far = 1, .flat = 4e-5, .steep = 6e-5};

// From so close that another program would take the triangle for the surface that the ray starts on.
inline constexpr Range kVeryClose{.away = 0.3, .near = 1e-7, .far = 1e-3, .flat = 0.57};

// The best-shaped triangles, met steeply and from close by. The precision is 2.2e-9 of the size.
inline constexpr Range kMostPrecise{.thin = 0.8, .away = 0.3, .near = 0.5, .far = 1, .flat = 1.2};

// Needles as thin as the contract's example, for the smallest and the largest scale. The precision
// is an eighth of the distance from the edges.
inline constexpr Range kNeedle{
    .size = 1, .thin = 1e-3, .thick = 1e-3, .away = 1, .near = 0.5, .far = 2, .flat = 0.57};

// Triangles of any size up to the thinness of a needle, and directions of any length, in cases of which
// the precision says what n is.
inline constexpr Range kAnyShape{
    .size = 1e6, .speed = 1e9, .thin = 1e-3, .away = 1, .near = 0.5, .far = 2, .flat = 0.57};

// The weights say whether the point is inside the triangle or outside.
inline Aims aims(const Range& range, Weights (*where)()) {
  return rc::gen::exec([=] {
    const pt::Triangle triangle = triangle_of(range);
    return aimed_at(triangle, where(), range);
  });
}
inline Aims aimed_inside(const Range& range = {}) { return aims(range, inside); }
inline Aims aimed_outside(const Range& range = {}) { return aims(range, outside); }

// The same ray, moved to the middle of the triangle.
inline Aimed at_the_middle(const Aimed& aimed) {
  return aimed_along(aimed.triangle, kMiddle, aimed.ray.direction, aimed.t);
}

// Corner normals whose weighted sum at the point is short: up to a tenth, and not zero.
inline Aims where_normals_cancel() {
  return rc::gen::exec([] {
    pt::Triangle triangle = triangle_of(kPrecise);
    const Weights w = in_the_middle();
    const pt::Frame around = *rotation();
    triangle.n2 = around.z;
    // The sum of the first two, as two sides of a triangle that have known lengths.
    const pt::Vec3 two = *magnitude(1e-3, 0.1) * *direction() - w.b2 * triangle.n2;
    const double sum = length(two);
    const double cosine = (sum * sum + w.b0 * w.b0 - w.b1 * w.b1) / (2 * w.b0 * sum);
    const pt::Frame plane = pt::frame_from_normal(two / sum);
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    triangle.n0 = cosine * plane.z + sine * plane.x;
    triangle.n1 = (two - w.b0 * triangle.n0) / w.b1;
    return aimed_at(triangle, w, kPrecise);
  });
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

// The same case with a longer or shorter direction.
inline Aimed longer(Aimed aimed, double factor) {
  aimed.ray.direction *= factor;
  aimed.t /= factor;
  aimed.tolerance /= factor;
  return aimed;
}

// The same. The range ends a little behind the point, and
// may begin a little before it.
inline Aimed scaled(const Aimed& made, double factor) {
  Aimed aimed = longer(made, factor);
  aimed.ray.t_min = *rc::gen::element(0.0, 0.75) * aimed.t;
  aimed.ray.t_max = 1.5 * aimed.t;
  return aimed;
}

// The same case at either end of the scale or at its own size, with a direction of any length.
inline Aimed at_any_size(const Aimed& aimed) {
  const Aimed made = resized(aimed, *rc::gen::element(1e-6, 1.0, 1e6));
  return longer(made, *rc::gen::element(1e-9, 1e-9, 1e9, *any_length()));
}

// The same ray with a range that ends before the point or begins behind it, often as close to it as
// the precision allows, or from behind the triangle.
inline Aimed out_of_range(Aimed aimed, int kind) {
  const double before = aimed.t - 2 * aimed.tolerance, behind = aimed.t + 2 * aimed.tolerance;
  if (kind == 0) aimed.ray.t_max = before * *rc::gen::element(1.0, 0.999, 0.5, 0.0);
  if (kind == 1) aimed.ray.t_min = behind * *rc::gen::element(1.0, 1.001, 1e3);
  if (kind == 2) {
    aimed.ray.direction = -aimed.ray.direction;
    aimed.ray.t_max = *rc::gen::oneOf(magnitude(1e-3, 1e3), rc::gen::element(1.0, pt::kInfinity));
  }
  return aimed;
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
inline Cases<Fan> aimed_between(double away = 10) {
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

// At either end of the scale or at its own size, with a direction at either end of its lengths.
inline Aims at_either_end(const Range& range) {
  return aimed_inside(range).with([](const Aimed& aimed) {
    const double factor = *rc::gen::element(1e-6, 1e6);
    return scaled(resized(aimed, factor), *rc::gen::element(1e-9, 1.0, 1e9));
  });
}

// The same aim with a first edge and a direction of length 1.
inline Aimed ordinary(const Aimed& aimed) {
  Aimed made = resized(aimed, 1 / length(aimed.triangle.p1 - aimed.triangle.p0));
  made = longer(made, 1 / length(aimed.ray.direction));
  made.ray.t_min = 0;
  made.ray.t_max = pt::kInfinity;
  return made;
}

}  // namespace grader::check::hit_triangle_inputs
