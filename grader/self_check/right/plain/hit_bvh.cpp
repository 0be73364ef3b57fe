#include "pt/tasks/hit_bvh.h"

#include "pt/tasks/hit_box.h"

#include <vector>
namespace pt {
std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& prims, const Ray& ray) {
  std::optional<Hit> best;
  if (bvh.nodes.empty()) return best;
  Ray r = ray;
  std::vector<int> stack{0};
  while (!stack.empty()) {
    const BvhNode& node = bvh.nodes[stack.back()];
    stack.pop_back();
    if (!hit_box(node.box, r)) continue;
    if (node.is_leaf()) {
      for (int i = 0; i < node.count; i++) {
        int id = bvh.order[node.first + i];
        auto h = hit_primitive(prims, id, r);
        if (h && h->t <= r.t_max) {
          best = Hit{h->t, h->n, id};
          r.t_max = h->t;
        }
      }
    } else {
      stack.push_back(node.right);
      stack.push_back(node.left);
    }
  }
  return best;
}
bool occluded_bvh(const Bvh& bvh, const Primitives& prims, const Ray& ray) {
  if (bvh.nodes.empty()) return false;
  std::vector<int> stack{0};
  while (!stack.empty()) {
    const BvhNode& node = bvh.nodes[stack.back()];
    stack.pop_back();
    if (!hit_box(node.box, ray)) continue;
    if (node.is_leaf()) {
      for (int i = node.first; i < node.first + node.count; i++)
        if (hit_primitive(prims, bvh.order[i], ray)) return true;
    } else {
      stack.push_back(node.left);
      stack.push_back(node.right);
    }
  }
  return false;
}
}  // namespace pt
