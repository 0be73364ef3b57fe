// right: a std::priority_queue of the nodes entered, the nearest first
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
  using Entry = std::pair<double, int>;  // where the ray enters, and which node
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  Ray part = ray;
  std::optional<Hit> best;
  const auto enter = [&](int node) {
    if (const auto interval = hit_box(bvh.nodes[node].box, part)) open.push({interval->min, node});
  };
  if (!bvh.nodes.empty()) enter(0);
  while (!open.empty() && open.top().first <= part.t_max) {
    const BvhNode& node = bvh.nodes[open.top().second];
    open.pop();
    if (!node.is_leaf()) {
      enter(node.left);
      enter(node.right);
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const auto hit = hit_primitive(primitives, bvh.order[i], part);
      if (!hit || (best && best->t <= hit->t)) continue;
      best = Hit{hit->t, hit->n, bvh.order[i]};
      part.t_max = std::min(part.t_max, hit->t);
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
