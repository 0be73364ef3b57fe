// right: no stack and no recursion. Each node has a link to the node that comes after all below it, and
// the walk follows the link if the ray misses the box (Smits 1998, Efficiency Issues for Ray Tracing).
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <vector>

namespace pt {

namespace {

constexpr int kEnd = -1;

// The links, made from the root down: after the left child comes the right one, and after the right child
// what comes after its parent.
std::vector<int> links_of(const Bvh& bvh) {
  std::vector<int> after(bvh.nodes.size(), kEnd);
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const BvhNode& node = bvh.nodes[i];
    if (node.is_leaf()) continue;
    after[node.left] = node.right;
    after[node.right] = after[i];
  }
  return after;
}

// Calls `visit` for each leaf that the ray enters, until it returns true.
template <class Visit>
void walk(const Bvh& bvh, const Ray& ray, const Visit& visit) {
  if (bvh.nodes.empty()) return;
  const std::vector<int> after = links_of(bvh);
  for (int i = 0; i != kEnd;) {
    const BvhNode& node = bvh.nodes[i];
    const bool enters = hit_box(node.box, ray).has_value();
    if (enters && node.is_leaf() && visit(node)) return;
    i = enters && !node.is_leaf() ? node.left : after[i];
  }
}

}  // namespace

std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  std::optional<Hit> nearest;
  Ray shortened = ray;
  walk(bvh, shortened, [&](const BvhNode& leaf) {
    for (int i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const int primitive = bvh.order[i];
      if (const auto hit = hit_primitive(primitives, primitive, shortened)) {
        nearest = Hit{hit->t, hit->n, primitive};
        shortened.t_max = hit->t;
      }
    }
    return false;
  });
  return nearest;
}

bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  bool found = false;
  walk(bvh, ray, [&](const BvhNode& leaf) {
    for (int i = leaf.first; i < leaf.first + leaf.count && !found; ++i) {
      found = hit_primitive(primitives, bvh.order[i], ray).has_value();
    }
    return found;
  });
  return found;
}

}  // namespace pt
