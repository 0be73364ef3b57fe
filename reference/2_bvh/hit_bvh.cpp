#include "pt/tasks/hit_bvh.h"

#include "pt/tasks/hit_box.h"

#include <utility>

namespace pt {

namespace {

// The search for the nearest hit. `ray` is a copy of the query's ray, and always ends at the
// nearest hit so far, so that surfaces behind this hit no longer count. Only a hit shortens the
// ray; a box does not.
struct Nearest {
  const Bvh& bvh;
  const Primitives& primitives;
  Ray ray;
  std::optional<Hit> hit{};

  // A node whose box the ray enters.
  void visit(const BvhNode& node) {
    if (node.is_leaf()) {
      visit_leaf(node);
      return;
    }
    const BvhNode* near = &bvh.nodes[node.left];
    const BvhNode* far = &bvh.nodes[node.right];
    std::optional<Interval> in_near = hit_box(near->box, ray);
    std::optional<Interval> in_far = hit_box(far->box, ray);
    // A hit in the child that is entered first may end the ray before the other child.
    if (in_near && in_far && in_far->min < in_near->min) {
      std::swap(near, far);
      std::swap(in_near, in_far);
    }
    if (in_near) visit(*near);
    if (in_far && in_far->min <= ray.t_max) visit(*far);
  }

  void visit_leaf(const BvhNode& leaf) {
    for (int i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const int primitive = bvh.order[i];
      if (const auto found = hit_primitive(primitives, primitive, ray)) {
        hit = {found->t, found->n, primitive};
        ray.t_max = found->t;
      }
    }
  }
};

// Returns whether there is any hit at or below a node whose box the ray enters. If the ray enters
// both children, a call searches one, and the loop goes on with the other.
bool any(const Bvh& bvh, const Primitives& primitives, const Ray& ray, int start) {
  const BvhNode* node = &bvh.nodes[start];
  while (!node->is_leaf()) {
    const BvhNode* left = &bvh.nodes[node->left];
    const BvhNode* right = &bvh.nodes[node->right];
    const bool in_left = hit_box(left->box, ray).has_value();
    const bool in_right = hit_box(right->box, ray).has_value();
    if (!in_left && !in_right) return false;
    if (in_left && in_right && any(bvh, primitives, ray, node->right)) return true;
    node = in_left ? left : right;
  }
  for (int i = node->first; i < node->first + node->count; ++i) {
    if (hit_primitive(primitives, bvh.order[i], ray)) return true;
  }
  return false;
}

}  // namespace

std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  if (bvh.nodes.empty() || !hit_box(bvh.nodes[0].box, ray)) return std::nullopt;
  Nearest nearest{bvh, primitives, ray};
  nearest.visit(bvh.nodes[0]);
  return nearest.hit;
}

bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  if (bvh.nodes.empty() || !hit_box(bvh.nodes[0].box, ray)) return false;
  return any(bvh, primitives, ray, 0);
}

}  // namespace pt
