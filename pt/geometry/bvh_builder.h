#pragma once

#include "pt/geometry/bvh.h"

#include <span>
#include <stdexcept>
#include <string>
#include <utility>
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
  int leaf(std::span<const int> primitives) {
    if (primitives.empty()) throw std::logic_error("BvhBuilder: a leaf without primitives");
    BvhNode node;
    node.first = static_cast<int>(order_.size());
    node.count = static_cast<int>(primitives.size());
    for (const int i : primitives) node.box.grow(boxes_[i]);
    order_.insert(order_.end(), primitives.begin(), primitives.end());
    return add(node);
  }

  // A node with two children. A node can be the child of one node only.
  int inner(int left, int right) {
    BvhNode node;
    for (const int child : {left, right}) {
      take(child);
      node.box.grow(nodes_[child].box);
    }
    node.left = left;
    node.right = right;
    return add(node);
  }

  // The tree below this node. Two children are next to each other in memory, because a ray is
  // tested against both.
  Bvh finish(int root) {
    take(root);
    Bvh tree{{nodes_[root]}, order_};
    tree.nodes.reserve(nodes_.size());
    std::vector<int> open{0};  // nodes of the tree whose children are not in it yet
    while (!open.empty()) {
      const int parent = open.back();
      open.pop_back();
      if (tree.nodes[parent].is_leaf()) continue;
      const auto [left, right] = std::pair{tree.nodes[parent].left, tree.nodes[parent].right};
      const int place = static_cast<int>(tree.nodes.size());
      tree.nodes[parent].left = place;
      tree.nodes[parent].right = place + 1;
      tree.nodes.insert(tree.nodes.end(), {nodes_[left], nodes_[right]});
      open.insert(open.end(), {place + 1, place});
    }
    return tree;
  }

 private:
  int add(const BvhNode& node) {
    nodes_.push_back(node);
    has_parent_.push_back(false);
    return static_cast<int>(nodes_.size()) - 1;
  }

  void take(int node) {
    if (node < 0 || node >= static_cast<int>(nodes_.size()) || has_parent_[node]) {
      throw std::logic_error("BvhBuilder: node " + std::to_string(node) +
                             " was not made, or has a parent already");
    }
    has_parent_[node] = true;
  }

  std::span<const Box> boxes_;
  std::vector<BvhNode> nodes_;  // children before their parents
  std::vector<bool> has_parent_;
  std::vector<int> order_;
};

}  // namespace pt
