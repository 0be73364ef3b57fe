#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_bvh.h"

#include <cmath>
#include <utility>
#include <vector>

namespace pt {

namespace {

std::optional<SurfaceHit> own_hit(const Primitives& primitives, int i, const Ray& ray) {
  if (primitives.is_triangle(i)) return hit_triangle(primitives.triangle(i), ray);
  const Sphere& sphere = primitives.sphere(i);
  const Vec3 oc = ray.origin - sphere.center;
  const double a = dot(ray.direction, ray.direction), b = dot(oc, ray.direction);
  const double root = std::sqrt(b * b - a * (dot(oc, oc) - sphere.radius * sphere.radius));
  for (const double t : {(-b - root) / a, (-b + root) / a}) {
    if (t >= ray.t_min && t <= ray.t_max) {
      return SurfaceHit{t, normalize(ray.at(t) - sphere.center)};
    }
  }
  return std::nullopt;
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
