// method: directions towards the lights only, as direct_lights chooses them
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/direct_hemisphere.h"

namespace pt {

Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  Rgb sum;
  for (const Light& light : scene.lights) {
    for (int i = 0; i < samples; ++i) {
      const LightSample sample = sample_light(light, point.p, sampler);
      const double cosine = dot(point.n, sample.wi);
      if (!(cosine > 0)) continue;
      if (scene.occluded(shadow_ray(point, sample.wi, sample.distance))) continue;
      sum += point.albedo / kPi * sample.radiance * cosine / sample.pdf / samples;
    }
  }
  return sum;
}

}  // namespace pt
