#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <utility>
#include <vector>

namespace pt {

namespace {

template <class Leaf>
void walk(const Bvh& bvh, const Ray& ray, Leaf leaf) {
  if (bvh.nodes.empty()) return;
  int stack[256];
  int size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const BvhNode& node = bvh.nodes[stack[--size]];
    if (!hit_box(node.box, ray)) continue;
    if (node.is_leaf()) {
      if (leaf(node)) return;
    } else if (size + 2 <= 256) {
      stack[size++] = node.right;
      stack[size++] = node.left;
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
