#pragma once

#include "grader/tasks/hit_bvh/cases.h"

#include <cmath>
#include <string>

// Rays whose range begins or ends exactly at a wall. A ray's range is closed, so that the wall is a hit.

namespace grader::check::hit_bvh_cases {

// Up to six walls across an axis, one behind the other. The range ends at the first of them, begins at
// the last one, or begins and ends at any one of them. All numbers are whole multiples of powers of two,
// so that the judge's hit_box and hit_triangle compute the same t, without rounding.
inline rc::Gen<Case> range_with_a_wall_at_its_end() {
  return rc::gen::exec([] {
    const int axis = *whole(0, 2), n = *whole(1, 6), kind = *whole(0, 2);
    const int wall = kind == 0 ? 0 : kind == 1 ? n - 1 : *whole(0, n - 1);
    const auto turned = [axis](double x, double y, double z) {
      pt::Vec3 p;
      p[(axis + 1) % 3] = x;
      p[(axis + 2) % 3] = y;
      p[axis] = z;
      return p;
    };
    Case c;
    for (int z = 0; z < n; ++z) {
      c.primitives.triangles.push_back(
          pt::flat_triangle(turned(-16, -16, z), turned(16, -16, z), turned(0, 16, z)));
    }
    const double speed = std::pow(2, *whole(-9, 9));
    c.ray = {turned(0.25, 0.5, -4), speed * turned(0.125, -0.25, 1)};
    const double t = (4 + wall) / speed;
    if (kind != 0) c.ray.t_min = t;
    if (kind != 1) c.ray.t_max = t;
    Many make(*sampler_seed());
    c.bvh = tree_of(c.primitives, Shape::random, 1, 0, make);
    const std::string ends[] = {"ends exactly at the first", "begins exactly at the last",
                                "begins and ends exactly at one of them"};
    c.how = std::string(words(Shape::random)) + ", walls behind each other; the ray's range " +
            ends[kind];
    return c;
  });
}

}  // namespace grader::check::hit_bvh_cases
