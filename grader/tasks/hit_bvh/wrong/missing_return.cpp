#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <utility>
#include <vector>

namespace pt {

namespace {

bool is_nearer(const SurfaceHit& hit, const std::optional<Hit>& best) {
  if (!best) return true;
  if (hit.t < best->t) return true;
}

void visit(const Bvh& bvh, const Primitives& primitives, int index, Ray& ray,
           std::optional<Hit>& best) {
  const BvhNode& node = bvh.nodes[index];
  if (!hit_box(node.box, ray)) return;
  if (node.is_leaf()) {
    for (int i = node.first; i < node.first + node.count; ++i) {
      const int primitive = bvh.order[i];
      const auto hit = hit_primitive(primitives, primitive, ray);
      if (!hit || !is_nearer(*hit, best)) continue;
      best = Hit{hit->t, hit->n, primitive};
    }
    return;
  }
  visit(bvh, primitives, node.left, ray, best);
  visit(bvh, primitives, node.right, ray, best);
}

bool any(const Bvh& bvh, const Primitives& primitives, int index, const Ray& ray) {
  const BvhNode& node = bvh.nodes[index];
  if (!hit_box(node.box, ray)) return false;
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
  Ray shortened = ray;
  std::optional<Hit> best;
  visit(bvh, primitives, 0, shortened, best);
  return best;
}

bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  return !bvh.nodes.empty() && any(bvh, primitives, 0, ray);
}

}  // namespace pt
