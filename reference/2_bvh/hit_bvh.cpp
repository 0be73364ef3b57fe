#include "pt/tasks/hit_bvh.h"

#include "pt/tasks/hit_box.h"

#include <utility>

namespace pt {

namespace {

// The nearest hit at or below one node. `ray` is a copy that ends at the nearest hit so far, so
// what comes back is nearer than anything found before.
std::optional<Hit> nearest(const Bvh& bvh, const Primitives& primitives, const BvhNode& node,
                           Ray ray) {
  std::optional<Hit> best;
  if (node.is_leaf()) {
    for (int i = node.first; i < node.first + node.count; ++i) {
      const int primitive = bvh.order[i];
      if (const auto hit = hit_primitive(primitives, primitive, ray)) {
        best = {hit->t, hit->n, primitive};
        ray.t_max = hit->t;
      }
    }
    return best;
  }

  // The child that the ray enters first is likely to end it before it gets to the other.
  const BvhNode* first = &bvh.nodes[node.left];
  const BvhNode* second = &bvh.nodes[node.right];
  std::optional<Interval> enter_first = hit_box(first->box, ray);
  std::optional<Interval> enter_second = hit_box(second->box, ray);
  if (enter_second && (!enter_first || enter_second->min < enter_first->min)) {
    std::swap(first, second);
    std::swap(enter_first, enter_second);
  }
  if (enter_first) best = nearest(bvh, primitives, *first, ray);
  if (best) ray.t_max = best->t;
  if (enter_second && enter_second->min <= ray.t_max) {
    if (const auto nearer = nearest(bvh, primitives, *second, ray)) best = nearer;
  }
  return best;
}

bool any(const Bvh& bvh, const Primitives& primitives, const BvhNode& node, const Ray& ray) {
  if (!hit_box(node.box, ray)) return false;
  if (!node.is_leaf()) {
    return any(bvh, primitives, bvh.nodes[node.left], ray) ||
           any(bvh, primitives, bvh.nodes[node.right], ray);
  }
  for (int i = node.first; i < node.first + node.count; ++i) {
    if (hit_primitive(primitives, bvh.order[i], ray)) return true;
  }
  return false;
}

}  // namespace

std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  if (bvh.nodes.empty() || !hit_box(bvh.nodes[0].box, ray)) return std::nullopt;
  return nearest(bvh, primitives, bvh.nodes[0], ray);
}

bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  return !bvh.nodes.empty() && any(bvh, primitives, bvh.nodes[0], ray);
}

}  // namespace pt
