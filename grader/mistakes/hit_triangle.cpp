#include "pt/tasks/hit_triangle.h"

#include "grader/check/random_numbers.h"
#include "grader/mistakes/battery.h"
#include "pt/math/frame.h"

#include <array>
#include <cmath>

namespace grader::mistakes {
namespace {

using namespace check;

using pt::Ray;
using pt::Triangle;
using pt::Vec3;

// A ray at the point of the triangle's plane with the weights b0, b1, b2. Its t is known.
struct Aim {
  Triangle triangle;
  Ray ray;
  double t = 1;
};

Vec3 unit(RandomNumbers& make) { return normalize(make.vector(-1, 1) + Vec3{0.1, 0.2, 0.3}); }

// A triangle with three different normals. All are on one side of the face or, if `back` is true,
// on the other.
Triangle some_triangle(RandomNumbers& make, double size, bool back) {
  Triangle t;
  const Vec3 center = size * make.vector(-2, 2);
  const Vec3 u = unit(make), v = normalize(cross(u, unit(make)));
  t.p0 = center;
  t.p1 = center + size * make.between(0.7, 1.3) * u;
  t.p2 = center + size * (make.between(-0.3, 0.6) * u + make.between(0.7, 1.3) * v);
  const Vec3 n = (back ? -1.0 : 1.0) * normalize(geometric_normal(t));
  t.n0 = normalize(n + make.vector(-0.7, 0.7));
  t.n1 = normalize(n + make.vector(-0.7, 0.7));
  t.n2 = normalize(n + make.vector(-0.7, 0.7));
  return t;
}

Aim aim(const Triangle& triangle, std::array<double, 3> b, RandomNumbers& make, double distance,
        double direction_length, double side) {
  const Vec3 p = b[0] * triangle.p0 + b[1] * triangle.p1 + b[2] * triangle.p2;
  const Vec3 face = normalize(geometric_normal(triangle));
  const Vec3 away = normalize(side * face + 0.5 * make.vector(-1, 1));
  Aim a{triangle, {p + distance * away, -direction_length * away}};
  a.t = distance / direction_length;
  return a;
}

void ask(Battery& battery, const Aim& a) {
  battery.ask([&]() -> Battery::Numbers {
    const auto hit = pt::hit_triangle(a.triangle, a.ray);
    if (!hit) return {};
    // The answer has only a flag that says whether t is precise enough. The error itself depends on
    // the method.
    return {hit->t / a.t, hit->n.x, hit->n.y, hit->n.z,
            flag(std::abs(hit->t - a.t) < 1e-9 * a.t + 1e-14)};
  });
}

void shapes(Battery& battery, RandomNumbers& make) {
  constexpr std::array<double, 3> kInside[] = {{.2, .3, .5}, {.6, .1, .3}, {.1, .8, .1}};
  for (const bool back : {false, true}) {
    for (const double side : {1.0, -1.0}) {
      for (const auto& b : kInside) {
        ask(battery, aim(some_triangle(make, 1, back), b, make, 3, make.between(0.3, 4.0), side));
      }
    }
  }
  constexpr std::array<double, 3> kOutside[] = {{-.3, .6, .7},   {.6, -.3, .7},   {.6, .7, -.3},
                                                {1.9, -.4, -.5}, {-.4, 1.9, -.5}, {-.4, -.5, 1.9}};
  for (const double side : {1.0, -1.0}) {
    for (const auto& b : kOutside) {
      ask(battery, aim(some_triangle(make, 1, false), b, make, 3, 1, side));
    }
  }
}

void ranges(Battery& battery, RandomNumbers& make) {
  constexpr double kInfinity = pt::kInfinity;
  constexpr std::array<double, 2> kRanges[] = {{1.1, kInfinity}, {0, .9},   {.9, 1.1},
                                               {1.1, 2},         {.5, 0.9}, {.2, kInfinity}};
  for (const auto& [low, high] : kRanges) {
    Aim a = aim(some_triangle(make, 1, false), {.3, .3, .4}, make, 2, make.between(.5, 2), 1);
    a.ray.t_min = low * a.t;
    a.ray.t_max = high * a.t;
    ask(battery, a);
  }
  Aim behind = aim(some_triangle(make, 1, false), {.3, .3, .4}, make, 2, 1, 1);
  behind.ray.direction = -behind.ray.direction;
  ask(battery, behind);
  for (const double near : {1e-2, 1e-3, 1e-5, 1e-7}) {
    ask(battery, aim(some_triangle(make, 1, false), {.3, .3, .4}, make, near, 1, 1));
  }
}

void scales(Battery& battery, RandomNumbers& make) {
  for (const double size : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 10.0, 1e3, 1e6}) {
    ask(battery, aim(some_triangle(make, size, false), {.3, .3, .4}, make, 3 * size, 1, 1));
    ask(battery, aim(some_triangle(make, size, false), {.3, .3, .4}, make, 3 * size, size, -1));
  }
  for (const double longer : {1e-6, 1e-3, 1e3, 1e6}) {
    ask(battery, aim(some_triangle(make, 1, false), {.3, .3, .4}, make, 3, longer, 1));
  }
}

// Triangles in or nearly in the planes of the axes, triangles without area, and rays in the plane
// of their triangle.
void special(Battery& battery, RandomNumbers& make) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double tilt : {0.0, 1e-12, 1e-9}) {
      Triangle t;
      t.p0[(axis + 1) % 3] = 1;
      t.p1[(axis + 2) % 3] = 1;
      t.p2 = Vec3{-1, -1, -1};
      t.p2[axis] = tilt;
      t.p0[(axis + 2) % 3] = tilt;
      const Vec3 n = normalize(geometric_normal(t));
      t.n0 = normalize(n + 0.4 * make.vector(-1, 1));
      t.n1 = t.n2 = n;
      ask(battery, aim(t, {.3, .3, .4}, make, 3, 1, 1));
    }
  }
  const Vec3 z{0, 0, 1};
  const Triangle line{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, z, z, z};
  const Triangle dot{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}, z, z, z};
  const Triangle flat{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, z, z, z};
  ask(battery, {line, {{1, 1, 3}, {0, 0, -1}}, 3});
  ask(battery, {line, {{1.2, 0.8, 3}, {0, 0, -1}}, 3});
  ask(battery, {dot, {{1, 1, 3}, {0, 0, -1}}, 3});
  ask(battery, {dot, {{1.1, 1, 3}, {0, 0, -1}}, 3});
  ask(battery, {flat, {{-3, 0.5, 0}, {1, 0, 0}}, 3});
  ask(battery, {flat, {{0.5, 0.5, 0}, {1, 0, 0}}, 1});
  ask(battery, {flat, {{0.5, 0.5, 1}, {1, 0, 0}}, 1});
}

// A ray at a point in the middle, which meets the plane at an angle of this sine.
Aim grazing(const Triangle& triangle, double distance, double sine) {
  const Vec3 target = 0.3 * triangle.p0 + 0.3 * triangle.p1 + 0.4 * triangle.p2;
  const Vec3 face = normalize(geometric_normal(triangle));
  const Vec3 along = normalize(triangle.p1 - triangle.p0);
  const Vec3 away = std::sqrt(1 - sine * sine) * along + sine * face;
  return {triangle, {target + distance * away, -away}, distance};
}

// Directions of any length, the very end of the range, flat angles, slivers, and points close to an
// edge or a corner.
void extremes(Battery& battery, RandomNumbers& make) {
  constexpr std::array<double, 3> kMiddle{.3, .3, .4};
  for (const double longer : {1e-9, 3e-8, 1e12}) {
    ask(battery, aim(some_triangle(make, 1, false), kMiddle, make, 3, longer, 1));
  }
  for (const double beyond : {1.0005, 1.00005}) {
    Aim a = aim(some_triangle(make, 1, false), kMiddle, make, 2, 1, 1);
    a.ray.t_max = beyond * a.t;
    ask(battery, a);
  }
  for (const double sine : {5e-2, 5e-4, 5e-6})
    ask(battery, grazing(some_triangle(make, 1, false), 3, sine));
  for (const double height : {3e-2, 3e-3}) {
    Triangle sliver = some_triangle(make, 1, false);
    sliver.p2 = 0.4 * sliver.p0 + 0.6 * sliver.p1 + height * (sliver.p2 - sliver.p0);
    ask(battery, aim(sliver, kMiddle, make, 3, 1, 1));
  }
  for (const double over : {5e-4, 5e-7}) {
    ask(battery, aim(some_triangle(make, 1, false), {-over, .4, .6 + over}, make, 3, 1, 1));
    ask(battery, aim(some_triangle(make, 1, false), {.4, .6 + over, -over}, make, 3, 1, 1));
  }
  ask(battery, aim(some_triangle(make, 1, false), {.9994, .0003, .0003}, make, 3, 1, 1));
  ask(battery, aim(some_triangle(make, 1, false), {.0003, .9994, .0003}, make, 3, 1, 1));
}

// Asks only whether there is a hit: right solutions differ in t here.
void ask_hit(Battery& battery, const Triangle& triangle, const Ray& ray) {
  battery.ask([&]() -> Battery::Numbers {
    if (!pt::hit_triangle(triangle, ray)) return {};
    return {1};
  });
}

// A flat triangle close to the world's origin, with a first edge of length 1. The third corner is at
// `along` on it, and `height` away from it.
Triangle near_the_origin(RandomNumbers& make, double along, double height) {
  const Vec3 u = unit(make), v = normalize(cross(u, unit(make)));
  const Vec3 p = 0.3 * make.vector(-1, 1);
  return pt::flat_triangle(p, p + u, p + along * u + height * v);
}

// A ray that meets the plane at a right angle, in the point with these weights.
Aim straight(const Triangle& triangle, std::array<double, 3> b, double distance) {
  const Vec3 p = b[0] * triangle.p0 + b[1] * triangle.p1 + b[2] * triangle.p2;
  const Vec3 face = normalize(geometric_normal(triangle));
  return {triangle, {p + distance * face, -face}, distance};
}

// Points so close to an edge that only double precision distinguishes inside from outside.
void by_a_hair(Battery& battery, RandomNumbers& make) {
  for (const double over : {1.2e-8, -1.2e-8}) {
    for (int corner = 0; corner < 3; ++corner) {
      std::array<double, 3> b{0.4, 0.4, 0.4};
      b[corner] = -over;
      b[(corner + 1) % 3] = 0.6 + over;
      const Aim a = straight(near_the_origin(make, 0.5, 0.9), b, 0.8);
      ask_hit(battery, a.triangle, a.ray);
    }
  }
}

// Grazing rays at triangles ten times as long as high: with one long edge from the first corner, and
// with two. Then the smallest needles, and directions of length 1 and the shortest.
void needles(Battery& battery, RandomNumbers& make) {
  for (const double along : {0.1, 0.9}) {
    const Aim a = grazing(near_the_origin(make, along, 0.1), 0.5, 1.2e-6);
    ask_hit(battery, a.triangle, a.ray);
  }
  for (const double longer : {1.0, 1e-9}) {
    Triangle needle = near_the_origin(make, 0.5, 1e-3);
    for (Vec3* p : {&needle.p0, &needle.p1, &needle.p2}) *p = 1e-6 * *p;
    Aim a = straight(needle, {.3, .3, .4}, 1e-6);
    a.ray.direction *= longer;
    ask_hit(battery, a.triangle, a.ray);
  }
}

// Corner normals at this distance from an axis, on three sides of it.
Triangle with_normals(RandomNumbers& make, double distance) {
  Triangle t = near_the_origin(make, 0.5, 0.9);
  const pt::Frame around = pt::frame_from_normal(normalize(t.n0 + 0.5 * make.vector(-1, 1)));
  t.n0 = normalize(around.to_world({distance, 0, 1}));
  t.n1 = normalize(around.to_world({-0.5 * distance, std::sqrt(0.75) * distance, 1}));
  t.n2 = normalize(around.to_world({-0.5 * distance, -std::sqrt(0.75) * distance, 1}));
  return t;
}

// Corner normals that all but agree, and that disagree: so that their mean is short, or by more than a
// right angle where their mean is long, and where one of them hardly counts.
void normals(Battery& battery, RandomNumbers& make) {
  ask(battery, straight(with_normals(make, 5e-5), {.2, .3, .5}, 1));
  ask(battery, straight(with_normals(make, std::tan(1.2)), {.3, .3, .4}, 1));
  ask(battery, straight(with_normals(make, std::tan(1.4)), {.8, .1, .1}, 1));
  ask(battery, straight(with_normals(make, std::tan(1.2)), {8e-6, .4, .6 - 8e-6}, 1));
}

}  // namespace

void run_battery(Battery& battery) {
  RandomNumbers make(3);
  shapes(battery, make);
  ranges(battery, make);
  scales(battery, make);
  special(battery, make);
  extremes(battery, make);
  by_a_hair(battery, make);
  needles(battery, make);
  normals(battery, make);
}

}  // namespace grader::mistakes
