// right: recursive; the nearer child first, and the farther one only if it may hold a nearer hit
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <utility>

namespace pt {

namespace {

struct Nearest {
  const Bvh& bvh;
  const Primitives& primitives;
  Ray ray;
  std::optional<Hit> hit{};

  void visit(const BvhNode& node) {
    if (node.is_leaf()) {
      for (int i = node.first; i < node.first + node.count; ++i) {
        const int primitive = bvh.order[i];
        const auto found = hit_primitive(primitives, primitive, ray);
        if (!found) continue;
        hit = Hit{found->t, found->n, primitive};
        ray.t_max = found->t;
      }
      return;
    }
    const BvhNode* near = &bvh.nodes[node.left];
    const BvhNode* far = &bvh.nodes[node.right];
    auto in_near = hit_box(near->box, ray), in_far = hit_box(far->box, ray);
    if (in_near && in_far && in_far->min < in_near->min) {
      std::swap(near, far);
      std::swap(in_near, in_far);
    }
    if (in_near) visit(*near);
    if (in_far && in_far->min <= ray.t_max) visit(*far);
  }
};

bool any(const Bvh& bvh, const Primitives& primitives, const Ray& ray, const BvhNode& node) {
  if (!hit_box(node.box, ray)) return false;
  for (int i = node.first; i < node.first + node.count; ++i) {
    if (hit_primitive(primitives, bvh.order[i], ray)) return true;
  }
  if (node.is_leaf()) return false;
  return any(bvh, primitives, ray, bvh.nodes[node.left]) ||
         any(bvh, primitives, ray, bvh.nodes[node.right]);
}

}  // namespace

std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  if (bvh.nodes.empty() || !hit_box(bvh.nodes[0].box, ray)) return std::nullopt;
  Nearest nearest{bvh, primitives, ray};
  nearest.visit(bvh.nodes[0]);
  return nearest.hit;
}

bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  return !bvh.nodes.empty() && any(bvh, primitives, ray, bvh.nodes[0]);
}

}  // namespace pt
