#include "pt/tasks/hit_bvh.h"

#include "pt/tasks/hit_box.h"

#include <functional>
#include <queue>
namespace pt {
// Best first: the box that is entered earliest is opened next.
std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  std::optional<Hit> best;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  auto limit = [&] {
    Ray r = ray;
    if (best) r.t_max = best->t;
    return r;
  };
  auto push = [&](int node) {
    if (auto in = hit_box(bvh.nodes[node].box, limit())) open.push({in->min, node});
  };
  if (!bvh.nodes.empty()) push(0);
  while (!open.empty()) {
    auto [enter, index] = open.top();
    open.pop();
    if (best && enter > best->t) break;
    const BvhNode& node = bvh.nodes[index];
    if (!node.is_leaf()) {
      push(node.left);
      push(node.right);
    }
    for (int i = 0; i < node.count; ++i) {
      int p = bvh.order[node.first + i];
      if (auto hit = hit_primitive(primitives, p, limit())) {
        if (!best || hit->t < best->t) best = {hit->t, hit->n, p};
      }
    }
  }
  return best;
}
bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  std::function<bool(int)> any = [&](int index) {
    const BvhNode& node = bvh.nodes[index];
    if (!hit_box(node.box, ray)) return false;
    if (!node.is_leaf()) return any(node.left) || any(node.right);
    for (int i = 0; i < node.count; ++i)
      if (hit_primitive(primitives, bvh.order[node.first + i], ray)) return true;
    return false;
  };
  return !bvh.nodes.empty() && any(0);
}
}  // namespace pt
