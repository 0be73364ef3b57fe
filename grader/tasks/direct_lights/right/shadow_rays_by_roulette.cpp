// right: weak draws send a shadow ray only with a probability, and count for more if they do (Russian
// roulette). The chance is large, so that many samples have about the noise of independent draws.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

#include <algorithm>

namespace pt {

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (const Light& light : scene.lights) {
    const int draws = is_delta(light) ? 1 : samples;
    double strongest = 0;  // of the light's draws so far
    for (int i = 0; i < draws; ++i) {
      const LightSample sample = sample_light(light, point.p, sampler);
      const Vec3 wi = point.frame.to_local(sample.wi);
      if (!(wi.z > 0)) continue;
      const Rgb f = diffuse_f(point.albedo, wo, wi);
      const Rgb found = f * sample.radiance * (wi.z / sample.pdf / draws);
      const double strength = max_channel(found);
      if (!(strength > 0)) continue;
      const double chance = std::clamp(2 * strength / strongest, 0.8, 1.0);
      strongest = std::max(strongest, strength);
      if (chance < 1 && sampler.next_1d() >= chance) continue;
      if (scene.occluded(shadow_ray(point, sample.wi, sample.distance))) continue;
      sum += found / chance;
    }
  }
  return sum;
}

}  // namespace pt
