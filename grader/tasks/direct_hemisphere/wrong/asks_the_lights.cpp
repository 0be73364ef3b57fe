// breaks: takes_the_emission_of_what_is_hit
// The choice of sampling is ignored: the lights are asked instead.
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"

namespace pt {

Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  return direct_lights(scene, point, samples, sampler);
}

}  // namespace pt
