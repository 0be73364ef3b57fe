// right: a tree of std::shared_ptr, flattened level by level at the end
#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <deque>
#include <list>
#include <memory>
#include <vector>

namespace pt {

namespace {

struct Node {
  Box box;
  std::shared_ptr<Node> left, right;
  std::list<int> primitives;
};

struct Item {
  int index;
  Box box;
};

std::shared_ptr<Node> build(std::vector<Item> items, int max_leaf) {
  auto node = std::make_shared<Node>();
  Box centroids;
  for (const Item& item : items) {
    node->box.grow(item.box);
    centroids.grow(item.box.center());
  }
  if (static_cast<int>(items.size()) <= max_leaf) {
    for (const Item& item : items) node->primitives.push_back(item.index);
    return node;
  }
  const Vec3 size = centroids.extent();
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  std::vector<Item> left, right;
  for (const Item& item : items) {
    const bool low = item.box.center()[axis] <= centroids.center()[axis];
    (low ? left : right).push_back(item);
  }
  if (left.empty() || right.empty()) {  // they coincide: by turns
    left.clear();
    right.clear();
    for (const Item& item : items) (left.size() > right.size() ? right : left).push_back(item);
  }
  node->left = build(std::move(left), max_leaf);
  node->right = build(std::move(right), max_leaf);
  return node;
}

}  // namespace

Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  Bvh bvh;
  if (boxes.empty()) return bvh;
  std::vector<Item> items;
  for (const Box& box : boxes) items.push_back({static_cast<int>(items.size()), box});
  std::deque<std::shared_ptr<Node>> open{build(items, max_leaf)};
  for (int taken = 1; !open.empty(); open.pop_front()) {
    const Node& from = *open.front();
    BvhNode to;
    to.box = from.box;
    if (from.left) {
      to.left = taken++;
      to.right = taken++;
      open.push_back(from.left);
      open.push_back(from.right);
    } else {
      to.first = static_cast<int>(bvh.order.size());
      to.count = static_cast<int>(from.primitives.size());
      bvh.order.insert(bvh.order.end(), from.primitives.begin(), from.primitives.end());
    }
    bvh.nodes.push_back(to);
  }
  return bvh;
}

}  // namespace pt
