#include "grader/mistakes/battery.h"

#include "grader/tasks/hit_sphere/inputs.h"
#include "pt/tasks/hit_sphere.h"

#include <algorithm>
#include <cmath>

namespace grader::mistakes {
namespace {

using namespace check;

using namespace hit_sphere_inputs;

double is_on_the_sphere(const Chord& line, const pt::SurfaceHit& hit) {
  return flag(off(line, hit).point < 1e-6);
}

void ask(Battery& battery, Chord line, double t_min = 0, double t_max = pt::kInfinity) {
  line.ray.t_min = t_min;
  line.ray.t_max = t_max;
  battery.ask([&]() -> Battery::Numbers {
    const auto hit = call(line);
    if (!hit) return {};
    return {hit->t / line.t_far, hit->n.x, hit->n.y, hit->n.z, is_on_the_sphere(line, *hit)};
  });
}

void plain(Battery& battery, RandomNumbers& make) {
  for (const double offset : {0.0, 0.2, 0.5, 0.9, 0.99, 1.01, 1.1, 1.3, 1.5, 2.0, 5.0}) {
    for (const double longer : {1.0, 0.4, 3.0}) {
      ask(battery, some_line(make, make.between(0.3, 3.0), offset, 4, longer));
    }
  }
  for (const double before : {0.7, 0.3, 0.0, -0.5}) {
    for (const double longer : {1.0, 2.5}) {
      ask(battery, some_line(make, make.between(0.5, 2.0), 0.3, before, longer));
    }
  }
  ask(battery, some_line(make, 1, 0.3, -3, 1));  // the sphere is behind the origin
}

void ranges(Battery& battery, RandomNumbers& make) {
  for (const auto& [low, high] : kRanges) {
    for (const double longer : {1.0, 2.5}) {
      const Chord line = some_line(make, make.between(0.5, 2.0), 0.3, 3, longer);
      ask(battery, line, std::max(0.0, line.t_at(low)), line.t_at(high));
    }
  }
  for (const double high : {0.5, 1.5}) {
    const Chord line = some_line(make, 1, 0.2, 0.4, 1);  // the ray starts inside
    ask(battery, line, 0, high * line.t_far);
    ask(battery, line, high * line.t_far, pt::kInfinity);
  }
}

void scales(Battery& battery, RandomNumbers& make) {
  for (const double radius : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e2, 1e4, 1e6}) {
    ask(battery, some_line(make, radius, 0.4, 3, 1));
    ask(battery, some_line(make, radius, 0.4, 3, radius));
    ask(battery, some_line(make, radius, 0.4, 0.1, 1));
    ask(battery, some_line(make, radius, 1.2, 3, 1));
  }
  // The ray starts just outside the surface or just inside it.
  for (const double above : {1e-2, 1e-3, 1e-4, 1e-5, 1e-7}) {
    ask(battery, some_line(make, 1, 0, 1 + above, 1));
    ask(battery, some_line(make, 1, 0, -1 + above, 1));
  }
  for (const double far : {10.0, 100.0, 300.0, 1000.0}) {
    ask(battery, some_line(make, 1, 0.6, far, 1));
  }
}

// Directions of any length, the exact end of the range, and rays that hardly touch.
void extremes(Battery& battery, RandomNumbers& make) {
  for (const double longer : {1e-9, 3e-8, 1e12}) {
    ask(battery, some_line(make, 1, 0.3, 3, longer));
  }
  for (const double beyond : {1.0005, 1.00005}) {
    const Chord line = some_line(make, 1, 0.3, 3, 1);
    ask(battery, line, 0, beyond * line.t_near);
  }
  for (const double cosine : {5e-2, 5e-3, 5e-4}) {
    ask(battery, some_line(make, 1, std::sqrt(1 - cosine * cosine), 3, 1));
  }
}

// Asks only whether the point is on the sphere to the contract's precision. If the ray nearly
// touches, right solutions differ in t and n.
void ask_point(Battery& battery, const Chord& line) {
  battery.ask([&]() -> Battery::Numbers {
    const auto hit = call(line);
    if (!hit) return {};
    return {is_on_the_sphere(line, *hit)};
  });
}

// Asks from 950 radii away, with two points on the sphere that are closer and closer together. The
// last ray passes so closely that a radius rounded up to single precision is enough for a hit.
void tangents(Battery& battery, RandomNumbers& make) {
  for (const double half : {2.7e-3, 2.2e-3, 1.75e-3}) {
    ask_point(battery, some_line(make, 1, std::sqrt(1 - half * half), 950, 1));
  }
  ask_point(battery, some_line(make, std::sqrt(1 + 6.5e-8), 1 + 2.2e-8, 3, 1));
}

// Asks from exactly the centre, a million radii from the world's origin, the smallest sphere with
// the shortest direction, and a range that ends inside the sphere for a direction shorter than 1.
void lengths(Battery& battery, RandomNumbers& make) {
  ask(battery, some_line(make, 1, 0, 0, 1));
  ask(battery, moved(some_line(make, 1, 0.3, 3, 1), {1e6, -7e5, 4e5}));
  ask(battery, some_line(make, 1e-6, 0.4, 3, 1e-9));
  const Chord slow = some_line(make, 1, 0.3, 3, 0.4);
  ask(battery, slow, 0, slow.t_at(1.2));
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
