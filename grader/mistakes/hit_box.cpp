#include "pt/tasks/hit_box.h"

#include "grader/check/random_numbers.h"
#include "grader/mistakes/battery.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace grader::mistakes {
namespace {

using namespace check;

using pt::Box;
using pt::Ray;
using pt::Vec3;

void ask(Battery& battery, const Box& box, const Ray& ray) {
  battery.ask([&]() -> Battery::Numbers {
    const auto inside = pt::hit_box(box, ray);
    if (!inside) return {};
    return {inside->min, inside->max};
  });
}

Box some_box(RandomNumbers& make, double size) {
  const Vec3 center = size * make.vector(-3, 3), half = size * make.vector(0.3, 1.5);
  return {center - half, center + half};
}

Vec3 inside(const Box& box, RandomNumbers& make) {
  return box.center() + 0.4 * make.between(-1, 1) * box.extent();
}

void anywhere(Battery& battery, RandomNumbers& make) {
  for (int i = 0; i < 24; ++i) {
    const Box box = some_box(make, i < 16 ? 1 : i < 20 ? 1e-5 : 1e5);
    const double size = max_abs(box.extent());
    const Vec3 origin = box.center() + 4 * size * normalize(make.vector(-1, 1));
    const Vec3 beside = i % 4 == 3 ? 2.5 * size * make.vector(-1, 1) : Vec3{};
    const Vec3 target = inside(box, make) + beside;
    ask(battery, box, {origin, make.between(0.1, 2) * (target - origin)});
  }
}

// Rays beside the box, on each side of each axis. Each of them is inside the other two slabs for
// some t.
void beside(Battery& battery, RandomNumbers& make) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      const Box box = some_box(make, 1);
      Vec3 target = box.center();
      target[axis] += side * 1.2 * box.extent()[axis];
      const int other = (axis + 1) % 3, third = (axis + 2) % 3;
      Vec3 d;
      d[other] = 1;
      d[third] = 0.5 * side;
      d[axis] = 0.05;
      ask(battery, box, {target - 7 * d, d});
      ask(battery, box, {target + 7 * d, -d});
    }
  }
}

// The ranges count in units of the box: 1 is where the ray enters it, 2 where it leaves it.
void ranges(Battery& battery, RandomNumbers& make) {
  constexpr std::array<double, 2> kRanges[] = {{0, .5},   {.5, 1.5},  {1.2, 1.8}, {1.5, 9},
                                               {2.5, 9},  {0, 9},     {-9, -1},   {1.2, 9},
                                               {.5, 2.5}, {2.2, 2.5}, {.2, .7}};
  for (const auto& [low, high] : kRanges) {
    for (const double longer : {1.0, 0.3}) {
      const Box box = some_box(make, 1);
      const Vec3 along = normalize(make.vector(-1, 1) + Vec3{0.2, 0.1, 0.3});
      const double entry = 5;
      double half = pt::kInfinity;
      for (int axis = 0; axis < 3; ++axis) {
        half = std::min(half, box.extent()[axis] / 2 / std::abs(along[axis]));
      }
      const auto at = [&](double where) { return entry - half + 2 * half * (where - 1); };
      Ray ray{box.center() - entry * along, longer * along};
      ray.t_min = std::max(0.0, at(low)) / longer;
      ray.t_max = std::max(0.0, at(high)) / longer;
      if (low < 0) {
        ray = {box.center() + entry * along, longer * along};
      }
      ask(battery, box, ray);
    }
  }
  for (int i = 0; i < 6; ++i) {
    const Box box = some_box(make, 1);
    Ray ray{inside(box, make), make.vector(-1, 1)};
    if (i % 2 == 1) ray.t_min = 0.05;
    if (i % 3 == 2) ray.t_max = 0.06;
    ask(battery, box, ray);
  }
}

void along_the_axes(Battery& battery, RandomNumbers& make) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      for (const double zero : {0.0, -0.0}) {
        const Box box = some_box(make, 1);
        Vec3 d{zero, zero, zero};
        d[axis] = sign;
        const Vec3 p = inside(box, make);
        Vec3 off = p;
        off[(axis + 1) % 3] = box.max[(axis + 1) % 3] + 0.5;
        Vec3 below = p;
        below[(axis + 2) % 3] = box.min[(axis + 2) % 3] - 0.5;
        for (const Vec3& through : {p, off, below}) ask(battery, box, {through - 6 * d, d});
        // One component is zero, the others are not.
        Vec3 slanted{0.7, -0.4, 0.5};
        slanted[axis] = zero;
        ask(battery, box, {p - 5 * slanted, slanted});
        Vec3 shifted = p - 5 * slanted;
        shifted[axis] = box.max[axis] + 0.3;
        ask(battery, box, {shifted, slanted});
      }
    }
  }
}

void flat(Battery& battery, RandomNumbers& make) {
  for (int axis = 0; axis < 3; ++axis) {
    Box box = some_box(make, 1);
    box.max[axis] = box.min[axis];
    const Vec3 p = inside(box, make), origin = p + Vec3{2.1, 3.3, 1.7};
    ask(battery, box, {origin, p - origin});
    // A segment with whole numbers. If numbers had to be rounded, a miss would be right too.
    Box segment{{2, 3, 4}, {2, 3, 4}};
    segment.max[axis] += 2;
    Vec3 d{-1, 2, -4}, from = segment.min - d;
    from[axis] += 1;
    ask(battery, segment, {from, d});
  }
}

// Directions of any length, boxes of any size, and rays that run nearly along a side.
void extremes(Battery& battery, RandomNumbers& make) {
  const Vec3 along{0.6, -0.5, 0.7};
  for (const double longer : {1e-9, 3e-8, 4e-7, 1e10}) {
    const Box box = some_box(make, 1);
    ask(battery, box, {inside(box, make) - 5 * along, longer * along});
  }
  for (const double size : {1e-8, 1e7}) {
    const Box box = some_box(make, size);
    ask(battery, box, {inside(box, make) - 5 * size * along, along});
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (const double flat : {5e-4, 5e-3}) {
      const Box box = some_box(make, 1);
      Vec3 direction{1, 1, 1};
      direction[axis] = flat;
      ask(battery, box, {inside(box, make) - 5 * direction, direction});
      // It leaves through the side that it runs along.
      Vec3 origin = box.center();
      origin[axis] = box.max[axis] - 0.1 * flat;
      ask(battery, box, {origin, direction});
    }
  }
}

// Asks whether the interval is as precise as a double can be.
void precisely(Battery& battery, RandomNumbers& make) {
  for (int i = 0; i < 3; ++i) {
    const Box box = some_box(make, 1);
    const double t = make.between(2, 5);
    Vec3 target = inside(box, make);
    target.x = box.min.x;
    const Vec3 direction = normalize(Vec3{1, 0.3, -0.2} + 0.1 * make.vector(-1, 1));
    const Ray ray{target - t * direction, direction};
    battery.ask([&]() -> Battery::Numbers {
      const auto inside = pt::hit_box(box, ray);
      if (!inside) return {};
      return {flag(std::abs(inside->min / t - 1) < 1e-9)};
    });
  }
}

// A billion of its sizes away, rays at the box and past an edge of it.
void far_away(Battery& battery, RandomNumbers& make) {
  constexpr double kFar = 1e9;
  for (int i = 0; i < 8; ++i) {
    const Box box = some_box(make, 1);
    const Vec3 d = normalize(make.vector(-1, 1));
    ask(battery, box, {inside(box, make) - kFar * d, d});
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Box box = some_box(make, 1);
    const int other = (axis + 1) % 3;
    Vec3 target = box.center(), d{0.3, 0.3, 0.3};
    target[axis] = box.max[axis] + 0.1;
    target[other] = box.max[other] + 0.1;
    d[axis] = 0.7;
    d[other] = -0.7;
    ask(battery, box, {target - kFar * d, d});
  }
}

// A ray that is almost parallel to a side. Half way to the box it crosses the plane of this side, so
// that a component counts which is small beside the direction, or as a number.
void almost_parallel(Battery& battery, RandomNumbers& make) {
  constexpr double kWay = 1e4;
  for (const auto& [slope, longer] : {std::pair{5e-10, 1.0}, {5e-11, 1.0}, {1e-7, 1e-9}}) {
    for (int axis = 0; axis < 3; ++axis) {
      const Box box = some_box(make, 1);
      Vec3 p = inside(box, make), d{0.6, 0.6, 0.6};
      p[axis] = box.max[axis] - 0.5 * slope * kWay;
      d[axis] = -slope;
      ask(battery, box, {p - kWay * d, longer * d});
    }
  }
}

// A range of a single point inside the box, and a flat box close to the origin of the ray.
void points(Battery& battery, RandomNumbers& make) {
  Box box = some_box(make, 1);
  const Vec3 along{0.6, -0.5, 0.7}, near{0.04, 0.05, 0.06};
  Ray ray{inside(box, make) - 5 * along, along};
  ray.t_min = ray.t_max = 5;
  ask(battery, box, ray);
  for (int axis = 0; axis < 3; ++axis) {
    box = some_box(make, 1);
    box.max[axis] = box.min[axis];
    ask(battery, box, {inside(box, make) + near, -near});
  }
}

}  // namespace

void run_battery(Battery& battery) {
  RandomNumbers make(6);
  anywhere(battery, make);
  beside(battery, make);
  ranges(battery, make);
  along_the_axes(battery, make);
  flat(battery, make);
  extremes(battery, make);
  precisely(battery, make);
  far_away(battery, make);
  almost_parallel(battery, make);
  points(battery, make);
}

}  // namespace grader::mistakes
