#pragma once

#include "pt/geometry/box.h"

#include <vector>

namespace pt {

// One box of the hierarchy: a leaf, which holds the primitives order[first .. first + count), or an
// inner node with two children, which are indices into the nodes.
struct BvhNode {
  Box box;
  int left = -1;
  int right = -1;
  int first = 0;
  int count = 0;

  bool is_leaf() const { return count > 0; }
};

// A bounding volume hierarchy over boxes 0 .. n - 1, flat in memory. Invariants of every tree, of
// any shape:
//   - without boxes there are no nodes; else nodes[0] is the root;
//   - order is a permutation of 0 .. n - 1, and the leaves' ranges cover it without overlap;
//   - a node's children have larger indices than the node, and every node except the root is the
//     child of exactly one node;
//   - a node's box contains the boxes of all primitives below it.
struct Bvh {
  std::vector<BvhNode> nodes;
  std::vector<int> order;
};

}  // namespace pt
