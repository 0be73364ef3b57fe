// Keeps a very large array on the stack.
#include "pt/tasks/hit_bvh.h"

namespace pt {

std::optional<Hit> hit_bvh(const Bvh& bvh, const Primitives&, const Ray&) {
  volatile double all[2 << 20];
  for (std::size_t i = 0; i < std::size(all); ++i) all[i] = static_cast<double>(bvh.nodes.size());
  if (all[17] < 0) return std::nullopt;
  return Hit{};
}

bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  return hit_bvh(bvh, primitives, ray).has_value();
}

}  // namespace pt
