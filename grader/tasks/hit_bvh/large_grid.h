#pragma once

#include "grader/check/language/show.h"
#include "grader/tasks/hit_bvh/trees.h"

#include <functional>
#include <string>

// Scenes with more primitives and more nodes than 16 bits can count, or 17 and 18 bits. A ray enters little
// of their trees, so that a query costs as much as in a small scene.

namespace grader::check::hit_bvh_inputs {

struct Grid {
  pt::Primitives primitives;
  pt::Bvh bvh;
};

// A tree that halves the order at each level, down to one primitive in a leaf. The order is the reverse
// of the primitives, so that primitives of large numbers are at small places.
inline pt::Bvh reversed_halves(const pt::Primitives& primitives) {
  pt::Bvh bvh;
  const int n = primitives.size();
  bvh.nodes.reserve(2 * static_cast<std::size_t>(n));
  for (int i = n - 1; i >= 0; --i) bvh.order.push_back(i);
  const std::function<int(int, int)> build = [&](int first, int last) {
    const int me = static_cast<int>(bvh.nodes.size());
    bvh.nodes.emplace_back();
    pt::BvhNode node;
    if (last - first == 1) {
      node.first = first;
      node.count = 1;
      node.box = bounds(primitives, bvh.order[first]);
    } else {
      const int middle = first + (last - first) / 2;
      node.left = build(first, middle);
      node.right = build(middle, last);
      node.box.grow(bvh.nodes[node.left].box);
      node.box.grow(bvh.nodes[node.right].box);
    }
    bvh.nodes[me] = node;
    return me;
  };
  build(0, n);
  return bvh;
}

// Spheres of radius 0.4 in a plane, one unit apart, in rows of 250.
inline Grid grid_of(int spheres) {
  constexpr int kRow = 250;
  Grid grid;
  for (int i = 0; i < spheres; ++i) {
    const int column = i % kRow, row = i / kRow;
    grid.primitives.spheres.push_back({{1.0 * column, 1.0 * row, 0}, 0.4});
  }
  grid.bvh = reversed_halves(grid.primitives);
  return grid;
}

inline const Grid& large_grid() {
  static const Grid grid = grid_of(70000);
  return grid;
}
// 300,001 nodes: the contract speaks of three hundred thousand. They are sent for each query, so it gets few.
inline const Grid& largest_grid() {
  static const Grid grid = grid_of(150001);
  return grid;
}
inline const Grid& small_grid() {
  static const Grid grid = grid_of(2000);
  return grid;
}

// A ray that meets the sphere order[place] of the grid and no other.
struct AimedInGrid {
  const Grid* grid;
  int place;

  int primitive() const { return grid->bvh.order[place]; }
  pt::Ray ray() const {
    const pt::Vec3 center = grid->primitives.sphere(primitive()).center;
    return {center + pt::Vec3{0.1, -0.05, -5}, {0, 0, 1}};
  }
};

inline void showValue(const AimedInGrid& aimed, std::ostream& out) {
  out << aimed.grid->primitives.size() << " spheres of radius 0.4 in a plane, in a tree of "
      << aimed.grid->bvh.nodes.size() << " nodes with one sphere in a leaf"
      << "\nthe ray meets only primitive " << aimed.primitive() << ", which is order["
      << aimed.place << "]\n"
      << show(aimed.ray());
}

inline std::string aim_of(const AimedInGrid& aimed) {
  return "primitive " + std::to_string(aimed.primitive());
}

// A large number of the primitive at a small place of the order, and a large place in a late node.
inline AimedInGrid first_in(const Grid& grid) { return {&grid, 9}; }
inline AimedInGrid last_in(const Grid& grid) { return {&grid, grid.primitives.size() - 10}; }
inline AimedInGrid first_in_grid() { return first_in(large_grid()); }
inline AimedInGrid last_in_grid() { return last_in(large_grid()); }
inline AimedInGrid last_in_the_largest_grid() { return last_in(largest_grid()); }

}  // namespace grader::check::hit_bvh_inputs
