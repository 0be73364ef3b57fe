#include "grader/check/language/curve.h"
#include "grader/check/language/property.h"
#include "grader/tasks/hit_triangle/exact.h"
#include "pt/geometry/box.h"

#include <algorithm>
#include <cmath>

namespace grader::check {
namespace {

using namespace hit_triangle_inputs;

double missed(const Aimed& aimed) { return call(aimed).has_value() ? 0 : 1; }

// Returns the error of t as a length.
double error_of_t(const Aimed& aimed) {
  const auto hit = call(aimed);
  expect(hit.has_value(), "a hit", "no hit");
  return std::abs(hit->t - aimed.t) * length(aimed.ray.direction);
}

// The largest coordinate, way or edge: the contract's precision is relative to it.
double largest_length(const Aimed& aimed) {
  return std::max({max_abs(aimed.ray.at(aimed.t)), aimed.t * length(aimed.ray.direction),
                   length(aimed.triangle.p1 - aimed.triangle.p0)});
}

constexpr double kSlope = 0.5;  // the angle between ray and plane where it is not what varies

CURVE(hit_triangle, small) {
  return {.title = "A small triangle, seen from a few of its sizes away",
          .input = "length of an edge",
          .error = "share of rays at its inside that miss",
          .source = "a limit for the determinant is a limit for the size of a triangle",
          .places = by_factors(1, 1e-12, 25),
          .promised = {{1e-6, 1}},
          .methods = {{"wrong/absolute_epsilon", "determinants below 1e-5 dropped"},
                      {"wrong/tiny_absolute_epsilon", "determinants below 1e-12 dropped"},
                      {"methods/determinants", "determinants, single precision", true}},
          .statistic = Statistic::mean,
          .measure = [](double edge) { return missed(resized(*aimed_inside({.size = 1}), edge)); }};
}

CURVE(hit_triangle, sliver) {
  return {.title = "A sliver",
          .input = "height over length",
          .error = "error of t, in the largest length of the case",
          .source = "the area is a difference of products that are much larger",
          .places = by_factors(1, 1e-12, 25),
          // Thinner triangles are thinner than the allowed error: they may be missed.
          .promised = {{1, 1e-3, [](double thin) { return kPrecision / thin / std::sin(kSlope); }}},
          .methods = {{"wrong/slivers_dropped", "slivers dropped"},
                      {"methods/determinants", "determinants, single precision", true},
                      {"right/elimination", "elimination with pivots"},
                      {"right/watertight", "in the frame of the ray"}},
          .measure = [](double thin) {
            const Aimed aimed = *aimed_inside(
                {.size = 1, .thin = thin, .thick = thin, .flat = kSlope, .steep = kSlope});
            return error_of_t(aimed) / largest_length(aimed);
          }};
}

CURVE(hit_triangle, flat_ray) {
  return {.title = "A ray that is almost parallel to the triangle",
          .input = "angle between ray and plane, in radians",
          .error = "error of t, in the largest length of the case",
          .source = "the determinant is the sine of the angle, and errors are divided by it",
          .places = by_factors(1, 1e-12, 25),
          .promised = {{1, 1e-6, [](double angle) { return kPrecision / std::sin(angle); }}},
          .methods = {{"wrong/grazing_rays_dropped", "flat rays dropped"},
                      {"methods/determinants", "determinants, single precision", true},
                      {"right/watertight", "in the frame of the ray"}},
          .measure = [](double angle) {
            const Aimed aimed = *aimed_inside({.size = 1,
                                               .thin = 1,
                                               .away = 1,
                                               .near = 0.1,
                                               .far = 3,
                                               .flat = angle,
                                               .steep = angle});
            return error_of_t(aimed) / largest_length(aimed);
          }};
}

CURVE(hit_triangle, far_from_the_origin) {
  return {.title = "A triangle far from the world's origin",
          .input = "distance from the world's origin, in lengths of an edge",
          .error = "error of t, in lengths of an edge",
          .source = "coordinates are rounded to a part of their size",
          .places = by_factors(1, 1e12, 25),
          // Beyond this, the allowed error is as large as the triangle.
          .promised = {{1, 1e7,
                        [](double away) { return kPrecision * (away + 1) / std::sin(kSlope); }}},
          .methods = {{"methods/determinants", "determinants, single precision", true},
                      {"right/watertight", "in the frame of the ray"}},
          .measure = [](double away) {
            return error_of_t(*aimed_inside(
                {.size = 1, .thin = 1, .away = away, .near = 1, .far = 1, .flat = kSlope}));
          }};
}

// Returns 1 if an answer about a triangle without area, or a ray in its plane, is a number that has
// nothing to do with the triangle. Rounding gives it some area, so that a hit is right, too.
double anywhere(const Aimed& c) {
  const auto hit = call(c);
  if (!hit) return 0;
  pt::Box box;
  for (const pt::Vec3 p : {c.triangle.p0, c.triangle.p1, c.triangle.p2}) box.grow(p);
  const pt::Vec3 p = c.ray.at(hit->t);
  const double slack = 1e-3 * length(box.extent()) + 1e-12 * max_abs(p);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(p[axis] >= box.min[axis] - slack && p[axis] <= box.max[axis] + slack)) return 1;
  }
  return 0;
}

// Turned so that no determinant is exactly 0, and moved so that all are rounding errors.
Aimed turned_and_moved(Aimed c, double away) {
  const pt::Frame turn = *rotation();
  const double edge = length(c.triangle.p1 - c.triangle.p0);
  const pt::Vec3 shift = (away > 1 ? away * std::max(edge, 1e-30) : 0.0) * *direction();
  const auto place = [&](pt::Vec3 p) { return turn.to_world(p) + shift; };
  c.triangle.p0 = place(c.triangle.p0);
  c.triangle.p1 = place(c.triangle.p1);
  c.triangle.p2 = place(c.triangle.p2);
  c.ray.origin = place(c.ray.origin);
  c.ray.direction = turn.to_world(c.ray.direction);
  return c;
}

CURVE(hit_triangle, without_area) {
  return {.title = "Triangles without area, and rays in the plane of a triangle",
          .input = "distance from the world's origin, in edges; at 1 nothing is rounded",
          .error = "share of rays with a hit that is not at the triangle, or not a number",
          .source = "a rounding error over another, or 0 / 0, which no comparison rejects",
          .places = by_factors(1, 1e9, 10),
          .promised = {{1, 1}},
          .methods = {{"wrong/nan_accepted", "rejects if t < t_min"},
                      {"methods/determinants", "determinants, no guard"},
                      {"right/relative_guard", "relative guard"},
                      {"methods/determinants", "determinants, single precision", true}},
          .statistic = Statistic::mean,
          .cases = 1000,
          .measure = [](double away) {
            const Aimed c = *whole(0, 1) == 0 ? *without_area() : *in_the_plane();
            return anywhere(away > 1 ? turned_and_moved(c, away) : c);
          }};
}

// A fan of four triangles as aimed_between() makes, with a ray exactly at their corner or an edge: all
// numbers are multiples of 2^-18, which single precision has too, up to ten edges from the origin.
// Farther away it rounds the corners, until they coincide. The rays of the promise have more digits,
// which single precision would round: they would no longer meet the edge.
Fan exactly_between(double away) {
  const auto on_grid = [](pt::Vec3 p, double steps) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::round(p[axis] * steps) / steps;
    return p;
  };
  constexpr double kOfCorners = 1 << 14, kOfRays = 1 << 18;
  Fan fan = *aimed_between(away);
  for (pt::Triangle& triangle : fan.triangles) {
    for (pt::Vec3* p : {&triangle.p0, &triangle.p1, &triangle.p2}) *p = on_grid(*p, kOfCorners);
  }
  const pt::Triangle& first = fan.triangles[0];
  const pt::Vec3 target = first.p0 + *whole(0, 14) / 16.0 * (first.p1 - first.p0);
  fan.ray.origin = target - on_grid(fan.ray.direction, kOfRays);
  fan.ray.direction = target - fan.ray.origin;
  return fan;
}

// The share of rays that pass between the triangles of a fan; `fan` draws one at a distance.
Curve between_triangles(const std::string& title, const std::vector<Method>& methods,
                        Fan (*fan)(double away)) {
  return {.title = title,
          .input = "distance from the world's origin, in lengths of an edge",
          .error = "share of rays that pass between the triangles",
          .source = "Woop, Benthin and Wald 2013, Watertight Ray/Triangle Intersection",
          .places = by_factors(1, 1e9, 10),
          .promised = {{.first = 1, .last = 1e9, .bonus = true}},
          .methods = methods,
          .statistic = Statistic::mean,
          .cases = 1000,
          .measure = [fan](double away) { return is_hit(fan(away)) ? 0 : 1; }};
}

CURVE(hit_triangle, shared_edge) {
  return between_triangles(
      "Rays at edges and corners that triangles share",
      {{"methods/determinants", "determinants"}, {"right/watertight", "in the frame of the ray"}},
      [](double away) { return *aimed_between(away); });
}

CURVE(hit_triangle, shared_edge_of_short_numbers) {
  return between_triangles("Rays at shared edges, with numbers that single precision has too",
                           {{"methods/determinants", "determinants"},
                            {"right/watertight", "in the frame of the ray"},
                            {"methods/determinants", "determinants, single precision", true}},
                           exactly_between);
}

}  // namespace
}  // namespace grader::check
