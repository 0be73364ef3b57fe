// breaks: works_from_several_threads_at_once
// Keeps its stack in a static variable, which two threads share.
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <utility>
#include <vector>

namespace pt {

namespace {

template <class Leaf>
void walk(const Bvh& bvh, const Ray& ray, Leaf leaf) {
  if (bvh.nodes.empty()) return;
  static std::vector<int> stack;
  stack.assign(1, 0);
  while (!stack.empty()) {
    const BvhNode& node = bvh.nodes[stack.back()];
    stack.pop_back();
    if (!hit_box(node.box, ray)) continue;
    if (node.is_leaf()) {
      if (leaf(node)) return;
    } else {
      stack.push_back(node.right);
      stack.push_back(node.left);
    }
  }
}

}  // namespace

std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  Ray shortened = ray;
  std::optional<Hit> best;
  walk(bvh, shortened, [&](const BvhNode& node) {
    for (int i = node.first; i < node.first + node.count; ++i) {
      if (const auto hit = hit_primitive(primitives, bvh.order[i], shortened)) {
        best = Hit{hit->t, hit->n, bvh.order[i]};
        shortened.t_max = hit->t;
      }
    }
    return false;
  });
  return best;
}

bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  bool found = false;
  walk(bvh, ray, [&](const BvhNode& node) {
    for (int i = node.first; i < node.first + node.count && !found; ++i) {
      found = hit_primitive(primitives, bvh.order[i], ray).has_value();
    }
    return found;
  });
  return found;
}

}  // namespace pt
