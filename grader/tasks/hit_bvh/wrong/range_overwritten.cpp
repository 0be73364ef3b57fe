#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

namespace pt {

namespace {

bool enters(const Box& box, Ray& ray) {
  const std::optional<Interval> inside = hit_box(box, ray);
  if (!inside) return false;
  ray.t_min = inside->min;
  ray.t_max = inside->max;
  return true;
}

void visit(const Bvh& bvh, const Primitives& primitives, int index, Ray& ray,
           std::optional<Hit>& best) {
  const BvhNode& node = bvh.nodes[index];
  if (!enters(node.box, ray)) return;
  if (node.is_leaf()) {
    for (int i = node.first; i < node.first + node.count; ++i) {
      const int primitive = bvh.order[i];
      const auto hit = hit_primitive(primitives, primitive, ray);
      if (!hit) continue;
      ray.t_max = hit->t;
      best = Hit{hit->t, hit->n, primitive};
    }
    return;
  }
  visit(bvh, primitives, node.left, ray, best);
  visit(bvh, primitives, node.right, ray, best);
}

bool any(const Bvh& bvh, const Primitives& primitives, int index, Ray& ray) {
  const BvhNode& node = bvh.nodes[index];
  if (!enters(node.box, ray)) return false;
  if (node.is_leaf()) {
    for (int i = node.first; i < node.first + node.count; ++i) {
      if (hit_primitive(primitives, bvh.order[i], ray)) return true;
    }
    return false;
  }
  return any(bvh, primitives, node.left, ray) || any(bvh, primitives, node.right, ray);
}

}  // namespace

std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  if (bvh.nodes.empty()) return std::nullopt;
  Ray range = ray;
  std::optional<Hit> best;
  visit(bvh, primitives, 0, range, best);
  return best;
}

bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  Ray range = ray;
  return !bvh.nodes.empty() && any(bvh, primitives, 0, range);
}

}  // namespace pt
