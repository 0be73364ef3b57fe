#pragma once

#include "grader/check/language/property.h"
#include "grader/tasks/build_bvh/walk.h"

#include <algorithm>
#include <string>
#include <vector>

// The invariants of a tree (pt/geometry/bvh.h), and of its leaves. Each function fails the case if its own
// is broken, and ends soon for any tree that is bounded (walk.h). Words are made for what is wrong only:
// most of the trees are right, and some have 66,000 leaves.

namespace grader::check::build_bvh_inputs {

// Every node's box must contain all boxes below it, and hardly more.
inline void expect_covered(const Input& input, const pt::Bvh& bvh) {
  const Below below = below_each_node(input, bvh);
  const double allowed = allowed_excess(input);
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const pt::Box &box = bvh.nodes[i].box, &needed = below.boxes[i];
    if (needed.is_empty()) continue;
    const bool covers = contains(box, needed);
    // A box that seems too large may belong to a primitive that is lost.
    const double more = excess(box, needed);
    if (covers && (!below.all || more <= allowed)) continue;
    const std::string has = node_name(static_cast<int>(i)) + " has the ";
    expect(covers, "a box that contains everything below it, " + show(needed),
           has + (box.is_empty() ? "empty box" : show(box)));
    expect(false,
           "a box no larger than everything below it, except for rounding errors, " + show(needed),
           has + show(box) + ", larger by " + show(more));
  }
}

inline void expect_every_primitive_once(const Input& input, const pt::Bvh& bvh) {
  const auto n = static_cast<int>(input.boxes.size());
  expect_equal("entries in order", static_cast<long long>(bvh.order.size()), n);
  std::vector<int> seen(n), covered(n);
  for (const int primitive : bvh.order) {
    const bool is_box = primitive >= 0 && primitive < n;
    if (!is_box)
      expect(false, "indices of boxes in order, 0 to " + name_of(n - 1), name_of(primitive));
    ++seen[primitive];
  }
  for (const int i : walk_from_root(bvh)) {
    const pt::BvhNode& node = bvh.nodes[i];
    if (!node.is_leaf()) continue;
    const bool is_part = node.first >= 0 && node.first <= n - node.count;
    if (!is_part)
      expect(
          false, "leaves that hold a part of order, which has " + name_of(n) + " entries",
          node_name(i) + " begins at " + name_of(node.first) + " and holds " + name_of(node.count));
    for (int k = node.first; k < node.first + node.count; ++k) ++covered[k];
  }
  for (int i = 0; i < n; ++i) {
    if (seen[i] == 1 && covered[i] == 1) continue;
    expect_equal("how often box " + name_of(i) + " is in order", seen[i], 1);
    expect_equal("how many leaves hold order[" + name_of(i) + "]", covered[i], 1);
  }
}

inline void expect_small_leaves(const Input& input, const pt::Bvh& bvh) {
  const std::vector<int> walk = walk_from_root(bvh);
  const auto large =
      std::ranges::find_if(walk, [&](int i) { return bvh.nodes[i].count > input.max_leaf; });
  if (large == walk.end()) return;
  expect(false, "at most " + name_of(input.max_leaf) + " primitives in every leaf",
         name_of(bvh.nodes[*large].count) + " in " + node_name(*large) + ", " +
             name_of(depths(bvh)[*large]) + " levels below the root");
}

inline void expect_split(const Input& input, const pt::Bvh& bvh) {
  std::vector<bool> below(bvh.nodes.size());  // whether there are primitives
  std::vector<int> walk = walk_from_root(bvh);
  std::ranges::reverse(walk);
  for (const int i : walk) {
    const pt::BvhNode& node = bvh.nodes[i];
    below[i] = has_children(node) ? below[node.left] || below[node.right] : node.is_leaf();
    if (!below[i]) expect(false, "something below every node", "nothing below " + node_name(i));
  }
  expect(bvh.nodes[0].is_leaf() <= (static_cast<int>(input.boxes.size()) <= input.max_leaf),
         "a root with two children", "a root that is a leaf of all boxes");
}

// Fails unless every node but the root has one parent, whose index is smaller: there is one way to
// each node, and no way round.
inline void expect_one_tree(const pt::Bvh& bvh) {
  const auto count = static_cast<int>(bvh.nodes.size());
  std::vector<int> parents(bvh.nodes.size());
  for (int i = 0; i < count; ++i) {
    if (!has_children(bvh.nodes[i])) continue;
    for (const int child : {bvh.nodes[i].left, bvh.nodes[i].right}) {
      expect_child(bvh, i, child);
      ++parents[child];
      if (child > i) continue;
      expect(false, "children after their parent in the list",
             node_name(child) + " is a child of " + node_name(i));
    }
  }
  expect_equal("parents of the root", parents[0], 0);
  for (int i = 1; i < count; ++i) {
    if (parents[i] != 1) expect_equal("parents of " + node_name(i), parents[i], 1);
  }
}

// Fails unless all boxes are divided into leaves that are small enough. The other invariants do not
// depend on boxes that coincide or on axes that are equally long; other promises judge them.
inline void expect_divided(const Input& input, const pt::Bvh& bvh) {
  expect_every_primitive_once(input, bvh);
  expect_small_leaves(input, bvh);
  expect_split(input, bvh);
}

}  // namespace grader::check::build_bvh_inputs
