#pragma once

#include "grader/tasks/hit_bvh/trees.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

// Walls that a ray meets one after the other, and spheres in a row.

namespace grader::check::hit_bvh_inputs {

// A wall across the z axis that goes through a point, and rises along x and y by these slopes.
inline pt::Triangle wall_at(pt::Vec3 met, double along_x = 0, double along_y = 0, double size = 9) {
  const auto at = [&](double x, double y) {
    return pt::Vec3{x, y, met.z + along_x * (x - met.x) + along_y * (y - met.y)};
  };
  return pt::flat_triangle(at(-size, -size), at(size, -size), at(0, 2 * size));
}

inline constexpr pt::Ray kThroughWalls{{0.3, 0.2, -5}, {0.01, -0.02, 1}};

// Walls one unit apart, or spheres, without a tree. The ray meets all of them.
inline Case walls_in_a_row(int walls, bool spheres = false) {
  Case c;
  c.ray = kThroughWalls;
  for (int i = 0; i < walls; ++i) {
    if (spheres) {
      c.primitives.spheres.push_back({c.ray.at(5.0 + i), 0.4});
    } else {
      c.primitives.triangles.push_back(wall_at({0, 0, 1.0 * i}));
    }
  }
  return c;
}

// Walls, of which all but one are in one leaf, the nearest of them at this place. The range ends
// before the next wall.
inline Case wide_leaf(int walls, int place) {
  RandomNumbers make(1);
  Case c;
  const double size = std::max(99.0, 0.1 * walls);  // the ray would meet all of them
  for (int i = 0; i < walls; ++i) {
    const double z = (place - i + walls) % walls + 1;
    c.primitives.triangles.push_back(wall_at({0, 0, z}, 0, 0, size));
  }
  c.primitives.triangles.push_back(wall_at({0, 0, walls + 9.0}, 0, 0, size));
  c.ray = kThroughWalls;
  c.ray.t_max = 6.5;
  c.bvh = tree_in_order(c.primitives, Shape::left_chain, make, walls);
  c.how = "a leaf of " + std::to_string(walls) + " walls and a leaf of one";
  return c;
}

// Walls with different slopes, all of which the ray meets at the same t. All numbers are whole
// multiples of powers of two, so that every right hit_triangle computes this t without rounding.
inline Case walls_at_one_t(int walls, RandomNumbers& make) {
  constexpr std::array kSlopes{0.0, 0.25, -0.25, 0.5, -0.5};
  Case c;
  for (int i = 0; i < walls; ++i) {
    const double slope = kSlopes.at(i), other = kSlopes.at(make.whole(0, 4));
    c.primitives.triangles.push_back(wall_at({0.75, -0.5, 0}, slope, other, 16));
  }
  c.ray = {{0.25, 0.5, -4}, {0.125, -0.25, 1}};
  c.bvh = tree_of(c.primitives, Shape::random, 2, 0, make);
  c.how = std::string(words(Shape::random)) + ", walls that the ray meets at the same t";
  return c;
}

// Six walls or spheres in a row. The ray meets all of them.
inline Case six_in_a_row(bool spheres, RandomNumbers& make) {
  Case c;
  for (int i = 0; i < 6; ++i) {
    const pt::Vec3 at{0, 0, 4.0 * i};
    if (spheres) {
      c.primitives.spheres.push_back({at, 1});
    } else {
      c.primitives.triangles.push_back(wall_at(at));
    }
  }
  c.bvh = tree_of(c.primitives, Shape::random, 1, 0, make);
  c.ray = {{0.1, 0.2, -6}, {0.01, -0.02, 1}};
  return c;
}

// Two walls that the ray meets at these t. The farther wall slants, so that the ray enters its box
// long before; it enters the flat box of the nearer wall where it meets the wall itself. So a query
// knows the farther hit when it has to decide about the nearer wall's box.
inline Case flat_wall_before_a_slanting_one(double near, double far, double slope) {
  Case c;
  c.ray = kThroughWalls;
  c.primitives.triangles = {wall_at(c.ray.at(near)), wall_at(c.ray.at(far), slope)};
  return c;
}

// The same walls, the farther wall first in order. Their distance is a part of t.
inline Case farther_wall_first(double near, double apart, Shape shape, RandomNumbers& make) {
  Case c = flat_wall_before_a_slanting_one(near, near * (1 + apart), 0.3);
  std::swap(c.primitives.triangles[0], c.primitives.triangles[1]);
  c.bvh = tree_in_order(c.primitives, shape, make);
  return c;
}

// The range ends exactly at a slanting wall. A flat wall is behind it.
inline Case range_that_ends_at_a_slanting_wall(RandomNumbers& make) {
  Case c = flat_wall_before_a_slanting_one(9, 7, 0.3);
  c.bvh = tree_in_order(c.primitives, Shape::random, make);
  c.ray.t_max = hit_primitive(c.primitives, 1, c.ray)->t;
  return c;
}

// Walls, one behind the other. At each level a leaf holds the farthest wall, so that a query which
// takes the nearer child first has as many leaves waiting as there are walls.
inline Case pile(int walls, bool to_the_left) {
  RandomNumbers make(1);
  Case c;
  for (int i = 0; i < walls; ++i) {
    const double z = to_the_left ? i : walls - i;
    c.primitives.triangles.push_back(wall_at({0, 0, z}, 0, 0, 99));
  }
  c.ray = kThroughWalls;
  const Shape shape = to_the_left ? Shape::left_chain : Shape::right_chain;
  c.bvh = tree_in_order(c.primitives, shape, make);
  c.how = std::string(words(shape)) + ", the farthest wall of those below";
  return c;
}

// The end of the range that is exactly at a wall. A ray's range is closed, so that the wall is a
// hit.
enum class End { last, first, both };

inline const char* words(End end) {
  return end == End::last    ? "ends exactly at the first"
         : end == End::first ? "begins exactly at the last"
                             : "begins and ends exactly at one of them";
}

// The same ray, from exactly the wall where its range begins or ends.
inline void start_at(pt::Ray& ray, double t) {
  ray.origin = ray.at(t);
  ray.t_min = std::max(0.0, ray.t_min - t);
  ray.t_max -= t;
}

inline pt::Vec3 turned(int axis, double x, double y, double z) {
  pt::Vec3 p;
  p[(axis + 1) % 3] = x;
  p[(axis + 2) % 3] = y;
  p[axis] = z;
  return p;
}

// Squares across an axis, one behind the other, flat or tilted about a diagonal. Each has two
// triangles, whose boxes are the same. The ray meets one of the two.
inline Case squares_in_halves(int axis, int squares, RandomNumbers& make) {
  Case c;
  for (int z = 0; z < squares; ++z) {
    const double tilt = make.whole(0, 1) * make.between(0.1, 0.4);
    const pt::Vec3 low = turned(axis, -1, -1, z), high = turned(axis, 1, 1, z);
    const pt::Vec3 back = turned(axis, 1, -1, z + tilt), front = turned(axis, -1, 1, z - tilt);
    c.primitives.triangles.push_back(pt::flat_triangle(low, back, front));
    c.primitives.triangles.push_back(pt::flat_triangle(high, front, back));
    if (make.whole(0, 1) == 0)
      std::swap(c.primitives.triangles.end()[-1], c.primitives.triangles.end()[-2]);
  }
  const auto at = [&](double z) {
    return turned(axis, make.between(-0.9, 0.9), make.between(-0.9, 0.9), z);
  };
  const pt::Vec3 from = at(-2), to = at(squares);
  c.ray = {from, to - from};
  c.bvh = tree_in_order(c.primitives, Shape::random, make);
  c.how = std::string(words(Shape::random)) + ", squares of two triangles with the same box";
  return c;
}

// Walls across an axis, one behind the other, in no order of the tree. All numbers are whole
// multiples of powers of two, so that the judge's hit_box and hit_triangle compute the same t,
// without rounding.
inline Case walls_and_range(int axis, int walls, int wall, End end, double speed,
                            RandomNumbers& make) {
  Case c;
  for (int z = 0; z < walls; ++z) {
    c.primitives.triangles.push_back(pt::flat_triangle(
        turned(axis, -16, -16, z), turned(axis, 16, -16, z), turned(axis, 0, 16, z)));
  }
  c.ray = {turned(axis, 0.25, 0.5, -4), speed * turned(axis, 0.125, -0.25, 1)};
  const double t = (4 + wall) / speed;
  if (end != End::last) c.ray.t_min = t;
  if (end != End::first) c.ray.t_max = t;
  c.bvh = tree_of(c.primitives, Shape::random, 1, 0, make);
  c.how = std::string(words(Shape::random)) + ", walls behind each other; the ray's range " +
          words(end);
  return c;
}

}  // namespace grader::check::hit_bvh_inputs
