#pragma once

#include "grader/tasks/build_bvh/walk.h"

#include <algorithm>
#include <vector>

// The boxes that a node's box has to contain, and the amount by which it may be larger.

namespace grader::check::build_bvh_inputs {

// The box around all primitives below each node. Wrong entries of leaves are skipped: the promise
// keeps_every_primitive_once judges them.
struct Below {
  std::vector<pt::Box> boxes;  // by node; empty where nothing is below
  bool all = true;             // each box of the input is below the root once
};

inline Below below_each_node(const Input& input, const pt::Bvh& bvh) {
  const std::size_t n = input.boxes.size();
  Below below{std::vector<pt::Box>(bvh.nodes.size())};
  std::vector<int> times(n);
  std::vector<int> walk = walk_from_root(bvh);
  std::ranges::reverse(walk);
  for (const int i : walk) {
    const pt::BvhNode& node = bvh.nodes[i];
    for (int k = node.first; node.is_leaf() && k < node.first + node.count; ++k) {
      const int primitive = primitive_at(bvh, k, n);
      if (primitive < 0) continue;
      below.boxes[i].grow(input.boxes[primitive]);
      ++times[primitive];
    }
    if (has_children(node)) {
      below.boxes[i].grow(below.boxes[node.left]);
      below.boxes[i].grow(below.boxes[node.right]);
    }
  }
  below.all = std::ranges::count(times, 1) == std::ssize(input.boxes);
  return below;
}

// Returns how far the outer box reaches beyond the inner box, on the side where it is farthest.
inline double excess(const pt::Box& outer, const pt::Box& inner) {
  double most = 0;
  for (int axis = 0; axis < 3; ++axis) {
    most = std::max({most, inner.min[axis] - outer.min[axis], outer.max[axis] - inner.max[axis]});
  }
  return most;
}

// Returns how much too large a box may be. Rounding errors of double are far smaller than this, and
// rounding errors of single precision far larger.
inline double allowed_excess(const Input& input) {
  double largest = 0;
  for (const pt::Box& box : input.boxes) {
    largest = std::max({largest, max_abs(box.min), max_abs(box.max)});
  }
  return 1e-9 * largest + 1e-300;
}

}  // namespace grader::check::build_bvh_inputs
