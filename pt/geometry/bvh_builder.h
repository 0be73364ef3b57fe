#pragma once

#include "pt/geometry/bvh.h"

#include <span>
#include <vector>

namespace pt {

// Makes a tree from its leaves up. It keeps the books for build_bvh: the box of each node, the
// indices of the children, and `order`. Each call returns the number of a new node:
//
//     BvhBuilder tree(boxes);
//     const int left = tree.leaf(some), right = tree.leaf(others);
//     return tree.finish(tree.inner(left, right));
//
// If the leaves hold every primitive once, the tree has the invariants of Bvh.
class BvhBuilder {
 public:
  // The boxes of all primitives. They must live as long as the builder.
  explicit BvhBuilder(std::span<const Box> boxes) : boxes_(boxes) {}

  // A leaf with these primitives, which are indices of boxes: at least one of them.
  int leaf(std::span<const int> primitives);

  // A node with two children. A node can be the child of one node only.
  int inner(int left, int right);

  // The tree below this node. Two children are next to each other in memory, because a ray is
  // tested against both.
  Bvh finish(int root);

 private:
  int add(const BvhNode& node);
  void take(int node);  // gives a node its parent, or throws std::logic_error

  std::span<const Box> boxes_;
  std::vector<BvhNode> nodes_;  // children before their parents
  std::vector<bool> has_parent_;
  std::vector<int> order_;
};

}  // namespace pt
