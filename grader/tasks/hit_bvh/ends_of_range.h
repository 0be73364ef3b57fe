#pragma once

#include "grader/tasks/hit_bvh/cases.h"

#include <cmath>
#include <string>

// Rays whose range begins or ends exactly at a wall. A ray's range is closed, so that the wall is a hit.

namespace grader::check::hit_bvh_cases {

// The end of the range that is exactly at a wall.
enum class End { last, first, both };

inline const char* words(End end) {
  return end == End::last    ? "ends exactly at the first"
         : end == End::first ? "begins exactly at the last"
                             : "begins and ends exactly at one of them";
}

// Walls across an axis, one behind the other, in no order of the tree. All numbers are whole multiples
// of powers of two, so that the judge's hit_box and hit_triangle compute the same t, without rounding.
inline Case walls_and_range(int axis, int walls, int wall, End end, double speed,
                            RandomNumbers& make) {
  const auto turned = [axis](double x, double y, double z) {
    pt::Vec3 p;
    p[(axis + 1) % 3] = x;
    p[(axis + 2) % 3] = y;
    p[axis] = z;
    return p;
  };
  Case c;
  for (int z = 0; z < walls; ++z) {
    c.primitives.triangles.push_back(
        pt::flat_triangle(turned(-16, -16, z), turned(16, -16, z), turned(0, 16, z)));
  }
  c.ray = {turned(0.25, 0.5, -4), speed * turned(0.125, -0.25, 1)};
  const double t = (4 + wall) / speed;
  if (end != End::last) c.ray.t_min = t;
  if (end != End::first) c.ray.t_max = t;
  c.bvh = tree_of(c.primitives, Shape::random, 1, 0, make);
  c.how = std::string(words(Shape::random)) + ", walls behind each other; the ray's range " +
          words(end);
  return c;
}

// Up to six walls. The range ends at the first of them, begins at the last one, or begins and ends at
// any one of them.
inline rc::Gen<Case> range_with_a_wall_at_its_end() {
  return rc::gen::exec([] {
    const int axis = *whole(0, 2), n = *whole(1, 6);
    const End end{*whole(0, 2)};
    const int wall = end == End::last ? 0 : end == End::first ? n - 1 : *whole(0, n - 1);
    const double speed = std::pow(2, *whole(-9, 9));
    RandomNumbers make(*sampler_seed());
    return walls_and_range(axis, n, wall, end, speed, make);
  });
}

}  // namespace grader::check::hit_bvh_cases
