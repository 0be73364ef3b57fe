// right: collects the leaves that the ray enters, sorts them by where, and then tests them
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

std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  std::vector<std::pair<double, const BvhNode*>> leaves;
  std::vector<int> open;
  if (!bvh.nodes.empty()) open.push_back(0);
  while (!open.empty()) {
    const BvhNode& node = bvh.nodes[open.back()];
    open.pop_back();
    const auto inside = hit_box(node.box, ray);
    if (!inside) continue;
    if (node.is_leaf()) {
      leaves.emplace_back(inside->min, &node);
    } else {
      open.push_back(node.left);
      open.push_back(node.right);
    }
  }
  std::sort(leaves.begin(), leaves.end());
  std::optional<Hit> best;
  for (const auto& [enter, leaf] : leaves) {
    if (best && best->t < enter) break;
    for (int i = leaf->first; i < leaf->first + leaf->count; ++i) {
      const auto hit = hit_primitive(primitives, bvh.order[i], ray);
      if (hit && (!best || hit->t < best->t)) best = Hit{hit->t, hit->n, bvh.order[i]};
    }
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
