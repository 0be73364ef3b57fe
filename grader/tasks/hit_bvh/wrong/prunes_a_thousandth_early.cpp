#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <utility>
#include <vector>

namespace pt {
namespace {
std::optional<Hit> search(const Bvh& bvh, const Primitives& primitives, Ray ray, bool any) {
  std::optional<Hit> best;
  std::vector<std::pair<int, double>> stack;
  if (bvh.nodes.size() > 0)
    if (const auto in = hit_box(bvh.nodes[0].box, ray)) stack.emplace_back(0, in->min);
  while (stack.size() > 0) {
    const auto [index, entry] = stack.back();
    stack.pop_back();
    if (best && entry >= 0.999 * best->t) continue;
    const BvhNode& node = bvh.nodes[index];
    if (node.is_leaf()) {
      for (int i = node.first; i < node.first + node.count; ++i) {
        const auto hit = hit_primitive(primitives, bvh.order[i], ray);
        if (!hit) continue;
        if (!best || hit->t < best->t) best = Hit{hit->t, hit->n, bvh.order[i]};
        ray.t_max = best->t;
        if (any) return best;
      }
    } else {
      auto l = hit_box(bvh.nodes[node.left].box, ray), r = hit_box(bvh.nodes[node.right].box, ray);
      if (l && r) {
        const bool left_first = l->min < r->min;
        stack.emplace_back(left_first ? node.right : node.left, left_first ? r->min : l->min);
        stack.emplace_back(left_first ? node.left : node.right, left_first ? l->min : r->min);
      } else if (l) {
        stack.emplace_back(node.left, l->min);
      } else if (r) {
        stack.emplace_back(node.right, r->min);
      }
    }
  }
  return best;
}
}  // namespace
std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  return search(bvh, primitives, ray, false);
}
bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  return search(bvh, primitives, ray, true).has_value();
}
}  // namespace pt
