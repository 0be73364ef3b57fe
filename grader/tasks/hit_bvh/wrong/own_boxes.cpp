#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <utility>
#include <vector>

namespace pt {

namespace {

bool own_box(const Box& box, const Ray& ray) {
  double enter = ray.t_min, leave = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1 / ray.direction[axis];
    double a = (box.min[axis] - ray.origin[axis]) * inverse;
    double b = (box.max[axis] - ray.origin[axis]) * inverse;
    if (a > b) std::swap(a, b);
    if (a > enter) enter = a;
    if (b < leave) leave = b;
  }
  return enter <= leave * (1 + 1e-15);
}

void visit(const Bvh& bvh, const Primitives& primitives, int index, Ray& ray,
           std::optional<Hit>& best) {
  const BvhNode& node = bvh.nodes[index];
  if (!own_box(node.box, ray)) return;
  if (node.is_leaf()) {
    for (int i = node.first; i < node.first + node.count; ++i) {
      const int primitive = bvh.order[i];
      const auto hit = hit_primitive(primitives, primitive, ray);
      if (!hit) continue;
      best = Hit{hit->t, hit->n, primitive};
      ray.t_max = hit->t;
    }
    return;
  }
  visit(bvh, primitives, node.left, ray, best);
  visit(bvh, primitives, node.right, ray, best);
}

bool any(const Bvh& bvh, const Primitives& primitives, int index, const Ray& ray) {
  const BvhNode& node = bvh.nodes[index];
  if (!own_box(node.box, ray)) return false;
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
