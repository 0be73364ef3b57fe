#include "bench/render_tracing.h"
#include "fast/3_direct/direct_lights_grouped.h"

namespace pt {

namespace {

std::uint32_t blocked(const Scene& scene, std::span<const Ray> rays) {
  if (render_tracing.groups) {
    if (render_tracing.embree) return render_tracing.embree->occluded8(rays);
    return scene.occluded(rays);
  }
  std::uint32_t mask = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    mask |= static_cast<std::uint32_t>(scene.occluded(rays[i])) << i;
  }
  return mask;
}

}  // namespace

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  return direct_lights_grouped(scene, point, samples, sampler,
                               [&](std::span<const Ray> rays) { return blocked(scene, rays); });
}

}  // namespace pt
