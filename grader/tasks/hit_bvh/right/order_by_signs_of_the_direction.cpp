// right: the children are visited along the axis on which their middles are farthest apart, forwards or
// backwards by the sign of the ray's direction. A box is tested when it is visited.
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <cmath>
#include <vector>

namespace pt {

namespace {

bool left_is_first(const Box& left, const Box& right, Vec3 direction) {
  const Vec3 way = right.center() - left.center();
  int axis = 0;
  for (const int other : {1, 2}) {
    if (std::abs(way[other]) > std::abs(way[axis])) axis = other;
  }
  return way[axis] * direction[axis] >= 0;
}

}  // namespace

std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  std::optional<Hit> nearest;
  Ray left_of_it = ray;
  std::vector<int> stack;
  if (!bvh.nodes.empty()) stack.push_back(0);
  while (!stack.empty()) {
    const BvhNode& node = bvh.nodes[stack.back()];
    stack.pop_back();
    if (!hit_box(node.box, left_of_it)) continue;
    for (int i = node.first; i < node.first + node.count; ++i) {
      const int primitive = bvh.order[i];
      const std::optional<SurfaceHit> hit = hit_primitive(primitives, primitive, left_of_it);
      if (!hit) continue;
      nearest = Hit{hit->t, hit->n, primitive};
      left_of_it.t_max = hit->t;
    }
    if (node.is_leaf()) continue;
    const Box &left = bvh.nodes[node.left].box, &right = bvh.nodes[node.right].box;
    const bool left_first = left_is_first(left, right, ray.direction);
    stack.push_back(left_first ? node.right : node.left);
    stack.push_back(left_first ? node.left : node.right);
  }
  return nearest;
}

bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  std::vector<int> stack;
  if (!bvh.nodes.empty()) stack.push_back(0);
  while (!stack.empty()) {
    const BvhNode& node = bvh.nodes[stack.back()];
    stack.pop_back();
    if (!hit_box(node.box, ray)) continue;
    for (int i = node.first; i < node.first + node.count; ++i) {
      if (hit_primitive(primitives, bvh.order[i], ray)) return true;
    }
    if (node.is_leaf()) continue;
    stack.push_back(node.right);
    stack.push_back(node.left);
  }
  return false;
}

}  // namespace pt
