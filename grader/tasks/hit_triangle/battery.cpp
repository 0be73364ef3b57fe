#include "grader/mistakes/battery.h"

#include "grader/check/generators/random_numbers.h"
#include "grader/tasks/hit_triangle/exact.h"
#include "pt/tasks/hit_triangle.h"

#include <array>
#include <cmath>

namespace grader::mistakes {
namespace {

using namespace check;

using namespace hit_triangle_inputs;

// The triangles and rays of the battery. They are of a fixed stream of random numbers.

pt::Frame some_frame(RandomNumbers& make) {
  return pt::frame_from_normal(normalize(make.vector(-1, 1) + pt::Vec3{0.1, 0.2, 0.3}));
}

// A triangle with three different normals. All are on one side of the face or, if `back` is true,
// on the other.
pt::Triangle some_triangle(RandomNumbers& make, double size, bool back = false) {
  const pt::Vec3 p0 = size * make.vector(-2, 2);
  const pt::Frame frame = some_frame(make);
  const double edge = size * make.between(0.7, 1.3);
  const double along = make.between(-0.3, 0.6), height = make.between(0.7, 1.3);
  std::array<pt::Vec3, 3> normals;
  for (pt::Vec3& n : normals) n = normalize((back ? -1 : 1) * frame.z + make.vector(-0.7, 0.7));
  return triangle_at(p0, frame, edge, along, height, normals);
}

// A triangle whose third corner is close to the first edge.
pt::Triangle some_sliver(RandomNumbers& make, double height) {
  pt::Triangle sliver = some_triangle(make, 1);
  sliver.p2 = 0.4 * sliver.p0 + 0.6 * sliver.p1 + height * (sliver.p2 - sliver.p0);
  return sliver;
}

// A triangle in the plane of two axes, or at a small tilt to it.
pt::Triangle nearly_in_a_plane(RandomNumbers& make, int axis, double tilt) {
  pt::Triangle t;
  t.p0[(axis + 1) % 3] = 1;
  t.p1[(axis + 2) % 3] = 1;
  t.p2 = {-1, -1, -1};
  t.p2[axis] = tilt;
  t.p0[(axis + 2) % 3] = tilt;
  t.n1 = t.n2 = normalize(geometric_normal(t));
  t.n0 = normalize(t.n1 + 0.4 * make.vector(-1, 1));
  return t;
}

// A flat triangle close to the world's origin, with a first edge of length 1.
pt::Triangle near_the_origin(RandomNumbers& make, double along, double height) {
  const pt::Frame frame = some_frame(make);
  return triangle_at(0.3 * make.vector(-1, 1), frame, 1, along, height,
                     {frame.z, frame.z, frame.z});
}

// A triangle with corner normals at this distance from an axis, on three sides of it.
pt::Triangle with_normals(RandomNumbers& make, double distance) {
  pt::Triangle t = near_the_origin(make, 0.5, 0.9);
  const pt::Frame around = pt::frame_from_normal(normalize(t.n0 + 0.5 * make.vector(-1, 1)));
  t.n0 = normal_at(around, distance, 0);
  t.n1 = normal_at(around, -0.5 * distance, std::sqrt(0.75) * distance);
  t.n2 = normal_at(around, -0.5 * distance, -std::sqrt(0.75) * distance);
  return t;
}

// A ray from the front (`side` is 1) or from the back (-1) of a triangle, at a steep angle.
Aimed some_aim(RandomNumbers& make, const pt::Triangle& triangle, Weights w, double distance,
               double speed = 1, double side = 1) {
  const pt::Vec3 away = normalize(pt::Vec3{0, 0, side} + 0.5 * make.vector(-1, 1));
  return aimed_at(triangle, w, -away, distance, speed);
}

// A ray that meets the plane at a right angle.
Aimed straight(const pt::Triangle& triangle, Weights w, double distance) {
  return aimed_at(triangle, w, {0, 0, -1}, distance, 1);
}

// A ray along the first edge, which meets the plane in the middle at an angle of this sine.
Aimed along_the_edge(const pt::Triangle& triangle, double distance, double sine) {
  const pt::Vec3 edge = plane_of(triangle).to_local(triangle.p0 - triangle.p1);
  const pt::Vec3 local = std::sqrt(1 - sine * sine) * normalize(edge) - pt::Vec3{0, 0, sine};
  return aimed_at(triangle, kMiddle, local, distance, 1);
}

// Ranges of a ray, in units of the t at the triangle.
constexpr std::array<double, 2> kRanges[] = {
    {1.1, pt::kInfinity}, {0, .9}, {.9, 1.1}, {1.1, 2}, {.5, 0.9}, {.2, pt::kInfinity}};

void ask(Battery& battery, const pt::Triangle& triangle, const pt::Ray& ray, double t) {
  battery.ask([&]() -> Battery::Numbers {
    const auto hit = pt::hit_triangle(triangle, ray);
    if (!hit) return {};
    // The answer has only a flag that says whether t is precise enough. The error itself depends on
    // the method.
    return {hit->t / t, hit->n.x, hit->n.y, hit->n.z,
            flag(std::abs(hit->t - t) < 1e-9 * t + 1e-14)};
  });
}

void ask(Battery& battery, const Aimed& a) { ask(battery, a.triangle, a.ray, a.t); }

void shapes(Battery& battery, RandomNumbers& make) {
  for (const bool back : {false, true}) {
    for (const double side : {1.0, -1.0}) {
      for (const Weights& w : kInside) {
        const double longer = make.between(0.3, 4.0);
        ask(battery, some_aim(make, some_triangle(make, 1, back), w, 3, longer, side));
      }
    }
  }
  for (const double side : {1.0, -1.0}) {
    for (const Weights& w : kOutside) {
      ask(battery, some_aim(make, some_triangle(make, 1), w, 3, 1, side));
    }
  }
}

void ranges(Battery& battery, RandomNumbers& make) {
  for (const auto& [low, high] : kRanges) {
    const double longer = make.between(0.5, 2);
    Aimed a = some_aim(make, some_triangle(make, 1), kMiddle, 2, longer);
    a.ray.t_min = low * a.t;
    a.ray.t_max = high * a.t;
    ask(battery, a);
  }
  Aimed behind = some_aim(make, some_triangle(make, 1), kMiddle, 2);
  behind.ray.direction = -behind.ray.direction;
  ask(battery, behind);
  for (const double near : {1e-2, 1e-3, 1e-5, 1e-7}) {
    ask(battery, some_aim(make, some_triangle(make, 1), kMiddle, near));
  }
}

void scales(Battery& battery, RandomNumbers& make) {
  for (const double size : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 10.0, 1e3, 1e6}) {
    ask(battery, some_aim(make, some_triangle(make, size), kMiddle, 3 * size));
    ask(battery, some_aim(make, some_triangle(make, size), kMiddle, 3 * size, size, -1));
  }
  for (const double longer : {1e-6, 1e-3, 1e3, 1e6}) {
    ask(battery, some_aim(make, some_triangle(make, 1), kMiddle, 3, longer));
  }
}

// Triangles in or nearly in the planes of the axes, triangles without area, and rays in the plane
// of their triangle.
void special(Battery& battery, RandomNumbers& make) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double tilt : {0.0, 1e-12, 1e-9}) {
      ask(battery, some_aim(make, nearly_in_a_plane(make, axis, tilt), kMiddle, 3));
    }
  }
  // No t is right for them: most of the rays start 3 away from their point.
  for (const Aimed& each : fixed_degenerates()) ask(battery, each.triangle, each.ray, 3);
}

// Directions of any length, the exact end of the range, flat angles, slivers, and points close to
// an edge or a corner.
void extremes(Battery& battery, RandomNumbers& make) {
  for (const double longer : {1e-9, 3e-8, 1e12}) {
    ask(battery, some_aim(make, some_triangle(make, 1), kMiddle, 3, longer));
  }
  for (const double beyond : {1.0005, 1.00005}) {
    Aimed a = some_aim(make, some_triangle(make, 1), kMiddle, 2);
    a.ray.t_max = beyond * a.t;
    ask(battery, a);
  }
  for (const double sine : {5e-2, 5e-4, 5e-6}) {
    ask(battery, along_the_edge(some_triangle(make, 1), 3, sine));
  }
  for (const double height : {3e-2, 3e-3}) {
    ask(battery, some_aim(make, some_sliver(make, height), kMiddle, 3));
  }
  for (const double over : {5e-4, 5e-7}) {
    ask(battery, some_aim(make, some_triangle(make, 1), {-over, .4, .6 + over}, 3));
    ask(battery, some_aim(make, some_triangle(make, 1), {.4, .6 + over, -over}, 3));
  }
  ask(battery, some_aim(make, some_triangle(make, 1), {.9994, .0003, .0003}, 3));
  ask(battery, some_aim(make, some_triangle(make, 1), {.0003, .9994, .0003}, 3));
}

// Asks only whether there is a hit: right solutions differ in t here.
void ask_hit(Battery& battery, const Aimed& a) {
  battery.ask([&]() -> Battery::Numbers {
    if (!call(a)) return {};
    return {1};
  });
}

// Points so close to an edge that only double precision distinguishes inside from outside.
void by_a_hair(Battery& battery, RandomNumbers& make) {
  for (const double over : {1.2e-8, -1.2e-8}) {
    for (const int first : {0, 2, 1}) {
      const Weights w = weights_of(-over, 0.6 + over, first);
      ask_hit(battery, straight(near_the_origin(make, 0.5, 0.9), w, 0.8));
    }
  }
}

// Grazing rays at triangles ten times as long as high, with one long edge from the first corner and
// with two. Then the smallest needles, and directions of length 1 and the shortest.
void needles(Battery& battery, RandomNumbers& make) {
  for (const double along : {0.1, 0.9}) {
    ask_hit(battery, along_the_edge(near_the_origin(make, along, 0.1), 0.5, 1.2e-6));
  }
  for (const double longer : {1.0, 1e-9}) {
    Aimed a = resized(straight(near_the_origin(make, 0.5, 1e-3), kMiddle, 1), 1e-6);
    a.ray.direction *= longer;
    ask_hit(battery, a);
  }
}

// Corner normals that nearly agree, and normals that disagree: their mean is short, or they differ
// by more than a right angle where their mean is long, or where one weight is small.
void normals(Battery& battery, RandomNumbers& make) {
  ask(battery, straight(with_normals(make, 5e-5), {.2, .3, .5}, 1));
  ask(battery, straight(with_normals(make, std::tan(1.2)), kMiddle, 1));
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
