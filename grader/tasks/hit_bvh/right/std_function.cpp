// right: a std::function that returns the nearer hit of its two children
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
  if (bvh.nodes.empty()) return {};
  const std::function<std::optional<Hit>(int, Ray)> nearest = [&](int index, Ray part) {
    const BvhNode& node = bvh.nodes[index];
    std::optional<Hit> best;
    const auto keep = [&](const std::optional<Hit>& hit) {
      if (!hit || (best && !(hit->t < best->t))) return;
      best = hit;
      part.t_max = hit->t;
    };
    if (!hit_box(node.box, part)) return best;
    for (int i = 0; i < node.count; ++i) {
      const int primitive = bvh.order[node.first + i];
      const auto hit = hit_primitive(primitives, primitive, part);
      if (hit) keep(Hit{hit->t, hit->n, primitive});
    }
    if (node.is_leaf()) return best;
    keep(nearest(node.right, part));
    keep(nearest(node.left, part));
    return best;
  };
  return nearest(0, ray);
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
