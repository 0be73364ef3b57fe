#pragma once

#include "grader/check/language/property.h"
#include "grader/tasks/build_bvh/inputs.h"
#include "pt/geometry/bvh.h"
#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

// Takes a tree from a submission, and walks an answer that may not be a tree. Its numbers are bounded
// when it comes in, every index is checked before it is used, and every node is visited once, so that
// a walk ends soon for any answer of a submission.

namespace grader::check::build_bvh_inputs {

inline std::string name_of(int number) { return std::to_string(number); }
inline std::string node_name(int index) { return "node " + name_of(index); }

// Fails unless the sizes and the counts of a tree for `n` boxes are of the size that some tree has, so
// that neither sums overflow nor loops over leaves are long. Wrong trees pass: promises judge them.
inline void expect_bounded(const pt::Bvh& bvh, std::size_t n) {
  const auto most = static_cast<int>(4 * n + 16);
  expect(std::ssize(bvh.nodes) <= most && std::ssize(bvh.order) <= most,
         fmt::format("at most {} nodes and {} entries in order for {} boxes",
                     2 * std::max<std::size_t>(n, 1) - 1, n, n),
         fmt::format("{} nodes and {} entries", bvh.nodes.size(), bvh.order.size()));
  // A tree in which inner nodes hold what is below them has n entries on every level.
  constexpr long long kLevels = 256;
  long long held = 0;
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const pt::BvhNode& node = bvh.nodes[i];
    if (!node.is_leaf()) continue;
    held += node.count;
    if (node.first >= -most && node.first <= most) continue;
    expect(false,
           fmt::format("leaves that hold a part of order, which has {} entries", bvh.order.size()),
           fmt::format("{} begins at {} and holds {}", node_name(static_cast<int>(i)), node.first,
                       node.count));
  }
  expect(held <= kLevels * most, fmt::format("leaves that hold {} boxes in all", n),
         fmt::format("{} in all", held));
}

// Returns the submission's tree: all calls of build_bvh by the judge are this one.
inline pt::Bvh built(std::span<const pt::Box> boxes, int max_leaf) {
  pt::Bvh bvh = pt::build_bvh(boxes, max_leaf);
  expect_bounded(bvh, boxes.size());
  return bvh;
}

inline bool contains(const pt::Box& outer, const pt::Box& inner) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(outer.min[axis] <= inner.min[axis] && outer.max[axis] >= inner.max[axis])) return false;
  }
  return true;
}

inline void expect_nodes(const pt::Bvh& bvh) { expect(!bvh.nodes.empty(), "a tree", "no nodes"); }

inline void expect_child(const pt::Bvh& bvh, int node, int child) {
  const auto count = static_cast<int>(bvh.nodes.size());
  if (child >= 0 && child < count) return;
  expect(
      false,
      "children that are nodes, 0 to " + name_of(count - 1) + ", of every node without primitives",
      node_name(node) + " holds no primitives and has the child " + name_of(child));
}

// Returns the primitive at place k of order, of `n` primitives; -1 if there is none.
inline int primitive_at(const pt::Bvh& bvh, int k, std::size_t n) {
  if (k < 0 || k >= std::ssize(bvh.order)) return -1;
  const int primitive = bvh.order[k];
  return primitive >= 0 && primitive < static_cast<int>(n) ? primitive : -1;
}

// A node without primitives and without children. A right tree has no such node; nothing is below
// it.
inline bool is_bare(const pt::BvhNode& node) {
  return !node.is_leaf() && node.left == -1 && node.right == -1;
}

inline bool has_children(const pt::BvhNode& node) { return !node.is_leaf() && !is_bare(node); }

// Returns all nodes that can be reached from the root. Each one comes after the node that leads to
// it.
inline std::vector<int> walk_from_root(const pt::Bvh& bvh) {
  expect_nodes(bvh);
  std::vector<bool> reached(bvh.nodes.size());
  std::vector<int> walk{0};
  reached[0] = true;
  for (std::size_t next = 0; next < walk.size(); ++next) {
    const pt::BvhNode& node = bvh.nodes[walk[next]];
    if (!has_children(node)) continue;
    for (const int child : {node.left, node.right}) {
      expect_child(bvh, walk[next], child);
      if (!reached[child]) walk.push_back(child);
      reached[child] = true;
    }
  }
  return walk;
}

// Returns the level of each node. It is 0 for the root and for nodes that cannot be reached from
// it.
inline std::vector<int> depths(const pt::Bvh& bvh) {
  std::vector<int> depth(bvh.nodes.size());
  for (const int i : walk_from_root(bvh)) {
    const pt::BvhNode& node = bvh.nodes[i];
    if (!has_children(node)) continue;
    for (const int child : {node.left, node.right}) {
      if (child != 0 && depth[child] == 0) depth[child] = depth[i] + 1;
    }
  }
  return depth;
}

inline int depth(const pt::Bvh& bvh) { return std::ranges::max(depths(bvh)); }

// 1,024 boxes are far apart in a row, which is three times as long in x as in z and twice as long
// in y. Every rule makes a tree of about ten levels for them. A list, a chain, a single leaf, or a
// tree in which all boxes equal the root's is not accepted as a tree, and then no promise holds.
inline void expect_a_tree_at_all() {
  constexpr int kBoxes = 1024, kMaxDepth = 100;
  Input row{{}, 2, ""};
  for (int i = 0; i < kBoxes; ++i) {
    const int place = i * 389 % kBoxes;  // each place once, not in order
    row.boxes.push_back(around(pt::Vec3{3.0, 2.0, 1.0} * place, {0.1, 0.1, 0.1}));
  }
  const pt::Bvh bvh = built(row.boxes, row.max_leaf);
  const std::string of = "before anything else, for 1,024 boxes in a row and max_leaf 2: ";
  expect(bvh.nodes.size() > kBoxes / 4, of + "a tree of some 1,000 nodes or more",
         std::to_string(bvh.nodes.size()) + " nodes");
  expect(depth(bvh) <= kMaxDepth, of + "a tree of about ten levels, at most 100",
         std::to_string(depth(bvh)) + " levels");
  const pt::Box& all = bvh.nodes[0].box;
  const bool some_smaller = std::ranges::any_of(bvh.nodes, [&](const pt::BvhNode& node) {
    return node.is_leaf() && !contains(node.box, all);
  });
  expect(some_smaller, of + "leaves with smaller boxes than the root",
         "every leaf with the box of the root");
}

// The boxes that a node's box has to contain, and the amount by which it may be larger.

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

// Returns how much too large a box may be. It is some thousand rounding errors of double: a box that is
// a rounding error larger than its children's boxes is that much larger at each level.
inline double allowed_excess(const Input& input) {
  double largest = 0;
  for (const pt::Box& box : input.boxes) {
    largest = std::max({largest, max_abs(box.min), max_abs(box.max)});
  }
  return 1e-12 * largest + 1e-300;
}

}  // namespace grader::check::build_bvh_inputs
