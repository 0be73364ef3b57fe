#include "grader/mistakes/battery.h"

#include "grader/tasks/hit_box/inputs.h"

#include <cmath>
#include <utility>

namespace grader::mistakes {
namespace {

using namespace check;

using namespace hit_box_inputs;

using pt::Vec3;

void ask(Battery& battery, const Case& c) {
  battery.ask([&]() -> Battery::Numbers {
    const auto inside = call(c);
    if (!inside) return {};
    return {inside->min, inside->max};
  });
}

void anywhere(Battery& battery, RandomNumbers& make) {
  for (int i = 0; i < 24; ++i) {
    const double size = i < 16 ? 1 : i < 20 ? 1e-5 : 1e5;
    ask(battery, from_anywhere(make, size, i % 4 == 3 ? 2.5 : 0));
  }
}

void beside(Battery& battery, RandomNumbers& make) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      const pt::Box box = some_box(make, 1);
      for (const double forwards : {1.0, -1.0}) {
        ask(battery, beside_a_side(box, axis, side, forwards));
      }
    }
  }
}

void ranges(Battery& battery, RandomNumbers& make) {
  for (const auto& [low, high] : kRanges) {
    for (const double longer : {1.0, 0.3}) ask(battery, in_a_range(make, low, high, longer));
  }
  for (int i = 0; i < 6; ++i) {
    const Vec3 d = make.vector(-1, 1);
    Case c = at_a_box(make, some_box(make, 1), d, 0);  // it starts inside
    if (i % 2 == 1) c.ray.t_min = 0.05;
    if (i % 3 == 2) c.ray.t_max = 0.06;
    ask(battery, c);
  }
}

void along_the_axes(Battery& battery, RandomNumbers& make) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      for (const double zero : {0.0, -0.0}) {
        for (const Case& c : along_an_axis(make, axis, sign, zero)) ask(battery, c);
      }
    }
  }
}

void flat(Battery& battery, RandomNumbers& make) {
  for (int axis = 0; axis < 3; ++axis) {
    ask(battery, at_a_box(make, flattened(some_box(make, 1), axis), {-2.1, -3.3, -1.7}, 1));
    // A segment with whole numbers. If numbers had to be rounded, a miss would be right too.
    Vec3 middle{2, 3, 4};
    middle[axis] += 1;
    ask(battery, segment_at(middle, axis, 1, {-1, 2, -4}, 1));
  }
}

constexpr Vec3 kAlong{0.6, -0.5, 0.7};

// Directions of any length, boxes of any size, and rays that run nearly along a side.
void extremes(Battery& battery, RandomNumbers& make) {
  for (const double longer : {1e-9, 3e-8, 4e-7, 1e10}) {
    ask(battery, at_a_box(make, some_box(make, 1), longer * kAlong, 5 / longer));
  }
  for (const double size : {1e-8, 1e7})
    ask(battery, at_a_box(make, some_box(make, size), kAlong, 5 * size));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double slope : {5e-4, 5e-3}) {
      Vec3 d{1, 1, 1};
      d[axis] = slope;
      const pt::Box box = some_box(make, 1);
      ask(battery, at_a_box(make, box, d, 5));
      // It leaves through the side that it runs along.
      ask(battery, {box, {beyond(box, box.center(), axis, 1, -0.1 * slope), d}});
    }
  }
}

// Asks whether the interval is as precise as a double can be.
void precisely(Battery& battery, RandomNumbers& make) {
  for (int i = 0; i < 3; ++i) {
    const double t = make.between(2, 5);
    const Case c = at_the_first_side(make, t);
    battery.ask([&]() -> Battery::Numbers {
      const auto inside = call(c);
      if (!inside) return {};
      return {flag(std::abs(inside->min / t - 1) < 1e-9)};
    });
  }
}

// Rays at a box and past an edge of it, from a billion of its sizes away.
void far_away(Battery& battery, RandomNumbers& make) {
  constexpr double kFar = 1e9;
  for (int i = 0; i < 8; ++i) {
    const Vec3 d = normalize(make.vector(-1, 1));
    ask(battery, at_a_box(make, some_box(make, 1), d, kFar));
  }
  for (int axis = 0; axis < 3; ++axis) ask(battery, past_an_edge(make, axis, kFar));
}

// The component that matters is small, compared with the others or as a number.
void almost_parallel(Battery& battery, RandomNumbers& make) {
  for (const auto& [slope, longer] : {std::pair{5e-10, 1.0}, {5e-11, 1.0}, {1e-7, 1e-9}}) {
    for (int axis = 0; axis < 3; ++axis) {
      const pt::Box box = some_box(make, 1);
      Case c = crossing_at(box, inside(box, make), {0.6, 0.6, 0.6}, axis, 1, -slope, 1e4);
      c.ray.direction *= longer;
      ask(battery, c);
    }
  }
}

// A range of a single point inside the box, and a flat box close to the origin of the ray.
void points(Battery& battery, RandomNumbers& make) {
  Case c = at_a_box(make, some_box(make, 1), kAlong, 5);
  c.ray.t_min = c.ray.t_max = 5;
  ask(battery, c);
  for (int axis = 0; axis < 3; ++axis) {
    ask(battery, at_a_box(make, flattened(some_box(make, 1), axis), {-0.04, -0.05, -0.06}, 1));
  }
}

// A box a billion across, so far away and with so short a direction that t is 1e22.
void farthest(Battery& battery, RandomNumbers& make) {
  ask(battery, at_a_box(make, some_box(make, 1e9), 1e-9 * kAlong, 1e22));
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
  farthest(battery, make);
}

}  // namespace grader::mistakes
