// right: a stack of nodes that were entered already, the farther child below the nearer
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <stack>
#include <utility>
#include <vector>

namespace pt {

namespace {

struct Entered {
  int node;
  double t;
};

}  // namespace

std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  std::optional<Hit> best;
  if (bvh.nodes.empty()) return best;
  Ray now = ray;
  std::stack<Entered> open;
  if (const auto root = hit_box(bvh.nodes.front().box, now)) open.push({0, root->min});
  while (!open.empty()) {
    const auto [index, t] = open.top();
    open.pop();
    if (t > now.t_max) continue;
    const BvhNode& node = bvh.nodes[index];
    if (node.is_leaf()) {
      for (int i = node.first; i != node.first + node.count; ++i) {
        const int primitive = bvh.order.at(static_cast<std::size_t>(i));
        if (const auto hit = hit_primitive(primitives, primitive, now)) {
          best.emplace(Hit{hit->t, hit->n, primitive});
          now.t_max = best->t;
        }
      }
      continue;
    }
    const auto left = hit_box(bvh.nodes[node.left].box, now);
    const auto right = hit_box(bvh.nodes[node.right].box, now);
    const bool right_first = right && (!left || right->min < left->min);
    if (left && right_first) open.push({node.left, left->min});
    if (right) open.push({node.right, right->min});
    if (left && !right_first) open.push({node.left, left->min});
  }
  return best;
}

bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  std::stack<int, std::vector<int>> open;
  if (!bvh.nodes.empty()) open.push(0);
  while (!open.empty()) {
    const BvhNode& node = bvh.nodes[static_cast<std::size_t>(open.top())];
    open.pop();
    if (!hit_box(node.box, ray)) continue;
    if (!node.is_leaf()) {
      open.push(node.left);
      open.push(node.right);
      continue;
    }
    const auto first = bvh.order.begin() + node.first;
    if (std::any_of(first, first + node.count, [&](int primitive) {
          return hit_primitive(primitives, primitive, ray).has_value();
        })) {
      return true;
    }
  }
  return false;
}

}  // namespace pt
