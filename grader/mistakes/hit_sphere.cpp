#include "pt/tasks/hit_sphere.h"

#include "grader/check/random_numbers.h"
#include "grader/mistakes/battery.h"

#include <array>
#include <cmath>

namespace grader::mistakes {
namespace {

using namespace check;

using pt::Ray;
using pt::Sphere;
using pt::Vec3;

Vec3 unit(RandomNumbers& make) { return normalize(make.vector(-1, 1) + Vec3{0.1, 0.2, 0.3}); }

void ask(Battery& battery, const Sphere& sphere, const Ray& ray, double t) {
  battery.ask([&]() -> Battery::Numbers {
    const auto hit = pt::hit_sphere(sphere, ray);
    if (!hit) return {};
    const Vec3 p = ray.at(hit->t) - sphere.center;
    return {hit->t / t, hit->n.x, hit->n.y, hit->n.z,
            flag(std::abs(length(p) / sphere.radius - 1) < 1e-6)};
  });
}

// A line that passes the centre at `offset` radii. The ray starts `before` radii in front of the
// centre, and enters and leaves the sphere at the known distances `near` and `far`.
struct Line {
  Sphere sphere;
  Ray ray;
  double near = 0, far = 0;  // values of t

  Line(RandomNumbers& make, double radius, double offset, double before, double direction_length)
      : sphere{3 * radius * make.vector(-1, 1), radius} {
    const Vec3 along = unit(make), beside = normalize(cross(along, unit(make)));
    const double half = std::sqrt(std::max(0.0, 1 - offset * offset));
    ray.origin = sphere.center + radius * (offset * beside - before * along);
    ray.direction = direction_length * along;
    near = radius * (before - half) / direction_length;
    far = radius * (before + half) / direction_length;
  }
};

void ask(Battery& battery, Line line, double t_min, double t_max) {
  line.ray.t_min = t_min;
  line.ray.t_max = t_max;
  ask(battery, line.sphere, line.ray, line.far);
}

void plain(Battery& battery, RandomNumbers& make) {
  for (const double offset : {0.0, 0.2, 0.5, 0.9, 0.99, 1.01, 1.1, 1.3, 1.5, 2.0, 5.0}) {
    for (const double longer : {1.0, 0.4, 3.0}) {
      const Line line(make, make.between(0.3, 3.0), offset, 4, longer);
      ask(battery, line, 0, pt::kInfinity);
    }
  }
  for (const double before : {0.7, 0.3, 0.0, -0.5}) {
    for (const double longer : {1.0, 2.5}) {
      ask(battery, Line(make, make.between(0.5, 2.0), 0.3, before, longer), 0, pt::kInfinity);
    }
  }
  ask(battery, Line(make, 1, 0.3, -3, 1), 0, pt::kInfinity);  // the sphere is behind the origin
}

// The ranges count in units of the chord: 1 is the near point, 2 the far point.
void ranges(Battery& battery, RandomNumbers& make) {
  constexpr std::array<double, 2> kRanges[] = {{0, .5},   {.5, 1.5}, {0, 1.5}, {1.2, 1.8},
                                               {1.5, 9},  {2.5, 9},  {.2, .7}, {1.5, 2.5},
                                               {.5, 2.5}, {0, 2.5}};
  for (const auto& [low, high] : kRanges) {
    for (const double longer : {1.0, 2.5}) {
      const Line line(make, make.between(0.5, 2.0), 0.3, 3, longer);
      const auto at = [&](double where) {
        return line.near + (where - 1) * (line.far - line.near);
      };
      ask(battery, line, std::max(0.0, at(low)), at(high));
    }
  }
  for (const double high : {0.5, 1.5}) {
    const Line line(make, 1, 0.2, 0.4, 1);  // the ray starts inside
    ask(battery, line, 0, high * line.far);
    ask(battery, line, high * line.far, pt::kInfinity);
  }
}

void scales(Battery& battery, RandomNumbers& make) {
  for (const double radius : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e2, 1e4, 1e6}) {
    ask(battery, Line(make, radius, 0.4, 3, 1), 0, pt::kInfinity);
    ask(battery, Line(make, radius, 0.4, 3, radius), 0, pt::kInfinity);
    ask(battery, Line(make, radius, 0.4, 0.1, 1), 0, pt::kInfinity);
    ask(battery, Line(make, radius, 1.2, 3, 1), 0, pt::kInfinity);
  }
  // The ray starts just outside the surface or just inside it.
  for (const double above : {1e-2, 1e-3, 1e-4, 1e-5, 1e-7}) {
    ask(battery, Line(make, 1, 0, 1 + above, 1), 0, pt::kInfinity);
    ask(battery, Line(make, 1, 0, -1 + above, 1), 0, pt::kInfinity);
  }
  for (const double far : {10.0, 100.0, 300.0, 1000.0}) {
    ask(battery, Line(make, 1, 0.6, far, 1), 0, pt::kInfinity);
  }
}

// Directions of any length, the very end of the range, and rays that hardly touch.
void extremes(Battery& battery, RandomNumbers& make) {
  for (const double longer : {1e-9, 3e-8, 1e12}) {
    ask(battery, Line(make, 1, 0.3, 3, longer), 0, pt::kInfinity);
  }
  for (const double beyond : {1.0005, 1.00005}) {
    const Line line(make, 1, 0.3, 3, 1);
    ask(battery, line, 0, beyond * line.near);
  }
  for (const double cosine : {5e-2, 5e-3, 5e-4}) {
    ask(battery, Line(make, 1, std::sqrt(1 - cosine * cosine), 3, 1), 0, pt::kInfinity);
  }
}

// Asks only whether the point is on the sphere to the contract's precision. Where the ray all but touches,
// right solutions differ in t and n.
void ask_point(Battery& battery, const Line& line) {
  battery.ask([&]() -> Battery::Numbers {
    const auto hit = pt::hit_sphere(line.sphere, line.ray);
    if (!hit) return {};
    const Vec3 p = line.ray.at(hit->t) - line.sphere.center;
    return {flag(std::abs(length(p) / line.sphere.radius - 1) < 1e-6)};
  });
}

// Asks from 950 radii away, with two points on the sphere that are closer and closer together. And past a
// sphere so closely that a radius which is rounded up to single precision is large enough for a hit.
void tangents(Battery& battery, RandomNumbers& make) {
  for (const double half : {2.7e-3, 2.2e-3, 1.75e-3}) {
    ask_point(battery, Line(make, 1, std::sqrt(1 - half * half), 950, 1));
  }
  ask_point(battery, Line(make, std::sqrt(1 + 6.5e-8), 1 + 2.2e-8, 3, 1));
}

// Asks from exactly the centre, a million radii from the world's origin, the smallest sphere with the
// shortest direction, and a range that ends inside the sphere for a direction shorter than 1.
void lengths(Battery& battery, RandomNumbers& make) {
  ask(battery, Line(make, 1, 0, 0, 1), 0, pt::kInfinity);
  Line away(make, 1, 0.3, 3, 1);
  const Vec3 shift{1e6, -7e5, 4e5};
  away.sphere.center += shift;
  away.ray.origin += shift;
  ask(battery, away, 0, pt::kInfinity);
  ask(battery, Line(make, 1e-6, 0.4, 3, 1e-9), 0, pt::kInfinity);
  const Line slow(make, 1, 0.3, 3, 0.4);
  ask(battery, slow, 0, 0.8 * slow.near + 0.2 * slow.far);
}

}  // namespace

void run_battery(Battery& battery) {
  RandomNumbers make(4);
  plain(battery, make);
  ranges(battery, make);
  scales(battery, make);
  extremes(battery, make);
  tangents(battery, make);
  lengths(battery, make);
}

}  // namespace grader::mistakes
