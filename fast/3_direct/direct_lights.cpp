#include "fast/3_direct/direct_lights_grouped.h"

namespace pt {

namespace {

// A single ray is traced faster without a group.
std::uint32_t blocked(const Scene& scene, std::span<const Ray> rays) {
  return rays.size() == 1 ? scene.occluded(rays.front()) : scene.occluded(rays);
}

}  // namespace

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  return direct_lights_grouped(scene, point, samples, sampler,
                               [&](std::span<const Ray> rays) { return blocked(scene, rays); });
}

}  // namespace pt
