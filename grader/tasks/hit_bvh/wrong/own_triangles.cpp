// breaks: asks_hit_box_and_hit_primitive
// Computes where triangles are hit itself, and never calls hit_primitive for them.
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <utility>
#include <vector>

namespace pt {

namespace {

std::optional<SurfaceHit> own_hit(const Primitives& primitives, int i, const Ray& ray) {
  if (!primitives.is_triangle(i)) return hit_sphere(primitives.sphere(i), ray);
  const Triangle& triangle = primitives.triangle(i);
  const Vec3 a = triangle.p1 - triangle.p0, b = triangle.p2 - triangle.p0;
  const Vec3 s = ray.origin - triangle.p0, h = cross(ray.direction, b), q = cross(s, a);
  const double det = dot(a, h), v = dot(s, h) / det, w = dot(ray.direction, q) / det;
  const double t = dot(b, q) / det;
  if (!(v >= 0 && w >= 0 && v + w <= 1 && t >= ray.t_min && t <= ray.t_max)) return std::nullopt;
  return SurfaceHit{t, normalize((1 - v - w) * triangle.n0 + v * triangle.n1 + w * triangle.n2)};
}

void visit(const Bvh& bvh, const Primitives& primitives, int index, Ray& ray,
           std::optional<Hit>& best) {
  const BvhNode& node = bvh.nodes[index];
  if (!hit_box(node.box, ray)) return;
  if (node.is_leaf()) {
    for (int i = node.first; i < node.first + node.count; ++i) {
      const int primitive = bvh.order[i];
      const auto hit = own_hit(primitives, primitive, ray);
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
  if (!hit_box(node.box, ray)) return false;
  if (node.is_leaf()) {
    for (int i = node.first; i < node.first + node.count; ++i) {
      if (own_hit(primitives, bvh.order[i], ray)) return true;
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
