// right: the parent tests both children's boxes and visits the nearer one first
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <utility>
#include <vector>

namespace pt {

namespace {

// The node's own box has been entered.
void visit(const Bvh& bvh, const Primitives& primitives, const BvhNode& node, Ray& ray,
           std::optional<Hit>& best) {
  for (int i = node.first; node.is_leaf() && i < node.first + node.count; ++i) {
    if (const auto hit = hit_primitive(primitives, bvh.order[i], ray)) {
      best = Hit{hit->t, hit->n, bvh.order[i]};
      ray.t_max = hit->t;
    }
  }
  if (node.is_leaf()) return;
  const BvhNode* near = &bvh.nodes[node.left];
  const BvhNode* far = &bvh.nodes[node.right];
  auto near_part = hit_box(near->box, ray), far_part = hit_box(far->box, ray);
  if (far_part && (!near_part || far_part->min < near_part->min)) {
    std::swap(near, far);
    std::swap(near_part, far_part);
  }
  if (near_part) visit(bvh, primitives, *near, ray, best);
  if (far_part && far_part->min <= ray.t_max) visit(bvh, primitives, *far, ray, best);
}

}  // namespace

std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  std::optional<Hit> best;
  Ray shortened = ray;
  if (bvh.nodes.empty() || !hit_box(bvh.nodes[0].box, ray)) return best;
  visit(bvh, primitives, bvh.nodes[0], shortened, best);
  return best;
}

bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  std::vector<int> open;
  if (!bvh.nodes.empty()) open.push_back(0);
  for (std::size_t next = 0; next < open.size(); ++next) {
    const BvhNode& node = bvh.nodes[open[next]];
    if (!hit_box(node.box, ray)) continue;
    for (int i = node.first; node.is_leaf() && i < node.first + node.count; ++i) {
      if (hit_primitive(primitives, bvh.order[i], ray)) return true;
    }
    if (!node.is_leaf()) open.insert(open.end(), {node.left, node.right});
  }
  return false;
}

}  // namespace pt
