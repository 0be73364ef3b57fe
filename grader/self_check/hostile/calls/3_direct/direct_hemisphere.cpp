// Hands the work on to direct_lights.
#include "pt/tasks/direct_hemisphere.h"

namespace pt {

Rgb direct_lights(const Scene&, const SurfacePoint&, int, Sampler&);

Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  return direct_lights(scene, point, samples, sampler);
}

}  // namespace pt
