#include "pt/tasks/build_bvh.h"

#include <algorithm>
#include <memory>
#include <vector>
namespace pt {
namespace {
struct Node {
  Box box;
  std::shared_ptr<Node> l, r;
  std::vector<int> prims;
};
std::shared_ptr<Node> make(std::span<const Box> boxes, std::vector<int> prims, size_t max_leaf) {
  auto node = std::make_shared<Node>();
  Box c;
  for (int i : prims) {
    node->box.grow(boxes[i]);
    c.grow(boxes[i].center());
  }
  if (prims.size() <= max_leaf) {
    node->prims = prims;
    return node;
  }
  Vec3 e = c.extent();
  int axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
  double mid = c.center()[axis];
  std::vector<int> left, right;
  for (int i : prims) (boxes[i].center()[axis] < mid ? left : right).push_back(i);
  if (left.empty() || right.empty()) {
    left.assign(prims.begin(), prims.begin() + prims.size() / 2);
    right.assign(prims.begin() + prims.size() / 2, prims.end());
  }
  node->l = make(boxes, left, max_leaf);
  node->r = make(boxes, right, max_leaf);
  return node;
}
int flatten(const std::shared_ptr<Node>& n, Bvh& out) {
  int me = (int)out.nodes.size();
  out.nodes.emplace_back();
  out.nodes[me].box = n->box;
  if (!n->l) {
    out.nodes[me].first = (int)out.order.size();
    out.nodes[me].count = (int)n->prims.size();
    out.order.insert(out.order.end(), n->prims.begin(), n->prims.end());
  } else {
    int l = flatten(n->l, out);
    int r = flatten(n->r, out);
    out.nodes[me].left = l;
    out.nodes[me].right = r;
  }
  return me;
}
}  // namespace
Bvh build_bvh(std::span<const Box> boxes, int max_leaf) {
  Bvh b;
  if (boxes.empty()) return b;
  std::vector<int> all;
  for (size_t i = 0; i < boxes.size(); i++) all.push_back((int)i);
  flatten(make(boxes, all, max_leaf), b);
  return b;
}
}  // namespace pt
