#include "pt/tasks/hit_triangle.h"

#include "grader/check/many.h"
#include "grader/mistakes/battery.h"

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

Vec3 unit(Many& make) { return normalize(make.vector(-1, 1) + Vec3{0.1, 0.2, 0.3}); }

// A triangle with three different normals. All are on one side of the face or, if `back` is true,
// on the other.
Triangle some_triangle(Many& make, double size, bool back) {
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

Aim aim(const Triangle& triangle, std::array<double, 3> b, Many& make, double distance,
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

void shapes(Battery& battery, Many& make) {
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

void ranges(Battery& battery, Many& make) {
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

void scales(Battery& battery, Many& make) {
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
void special(Battery& battery, Many& make) {
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

// A ray that meets the plane at an angle of this sine.
Aim grazing(Many& make, double sine) {
  Aim a = aim(some_triangle(make, 1, false), {.3, .3, .4}, make, 3, 1, 1);
  const Vec3 target = a.ray.at(a.t), face = normalize(geometric_normal(a.triangle));
  const Vec3 along = normalize(a.triangle.p1 - a.triangle.p0);
  const Vec3 away = std::sqrt(1 - sine * sine) * along + sine * face;
  a.ray = {target + 3 * away, -away};
  return a;
}

// Directions of any length, the very end of the range, flat angles, slivers, and points close to an
// edge or a corner.
void extremes(Battery& battery, Many& make) {
  constexpr std::array<double, 3> kMiddle{.3, .3, .4};
  for (const double longer : {1e-9, 3e-8, 1e12}) {
    ask(battery, aim(some_triangle(make, 1, false), kMiddle, make, 3, longer, 1));
  }
  for (const double beyond : {1.0005, 1.00005}) {
    Aim a = aim(some_triangle(make, 1, false), kMiddle, make, 2, 1, 1);
    a.ray.t_max = beyond * a.t;
    ask(battery, a);
  }
  for (const double sine : {5e-2, 5e-4, 5e-6}) ask(battery, grazing(make, sine));
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

}  // namespace

void run_battery(Battery& battery) {
  Many make(3);
  shapes(battery, make);
  ranges(battery, make);
  scales(battery, make);
  special(battery, make);
  extremes(battery, make);
}

}  // namespace grader::mistakes
