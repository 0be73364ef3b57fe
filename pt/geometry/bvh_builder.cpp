#include "pt/geometry/bvh_builder.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace pt {

int BvhBuilder::leaf(std::span<const int> primitives) {
  if (primitives.empty()) throw std::logic_error("BvhBuilder: a leaf without primitives");
  BvhNode node;
  node.first = static_cast<int>(order_.size());
  node.count = static_cast<int>(primitives.size());
  for (const int i : primitives) {
    if (i < 0 || i >= std::ssize(boxes_)) {
      throw std::logic_error("BvhBuilder: primitive " + std::to_string(i) + " is not one of the " +
                             std::to_string(boxes_.size()) + " boxes");
    }
    node.box.grow(boxes_[i]);
  }
  order_.insert(order_.end(), primitives.begin(), primitives.end());
  return add(node);
}

int BvhBuilder::inner(int left, int right) {
  BvhNode node;
  for (const int child : {left, right}) {
    take(child);
    node.box.grow(nodes_[child].box);
  }
  node.left = left;
  node.right = right;
  return add(node);
}

Bvh BvhBuilder::finish(int root) {
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

int BvhBuilder::add(const BvhNode& node) {
  nodes_.push_back(node);
  has_parent_.push_back(false);
  return static_cast<int>(nodes_.size()) - 1;
}

void BvhBuilder::take(int node) {
  if (node < 0 || node >= static_cast<int>(nodes_.size()) || has_parent_[node]) {
    throw std::logic_error("BvhBuilder: node " + std::to_string(node) +
                           " was not made, or has a parent already");
  }
  has_parent_[node] = true;
}

}  // namespace pt
