// Calls itself for ever.
#include "pt/tasks/hit_bvh.h"

namespace pt {

std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  const Ray again = ray;
  auto hit = hit_bvh(bvh, primitives, again);
  if (hit) hit->t += 1;
  return hit;
}

bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  return hit_bvh(bvh, primitives, ray).has_value();
}

}  // namespace pt
