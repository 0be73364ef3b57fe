// right: colors and cosines in single precision, f written out with pi to six digits.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/direct_lights.h"

namespace pt {

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  float r = 0, g = 0, b = 0;
  for (const Light& light : scene.lights) {
    const int draws = is_delta(light) ? 1 : samples;
    for (int i = 0; i < draws; ++i) {
      const LightSample sample = sample_light(light, point.p, sampler);
      const float x = static_cast<float>(sample.wi.x) * static_cast<float>(point.n.x);
      const float y = static_cast<float>(sample.wi.y) * static_cast<float>(point.n.y);
      const float z = static_cast<float>(sample.wi.z) * static_cast<float>(point.n.z);
      const float cosine = x + y + z;
      if (!(dot(sample.wi, point.n) > 0) || !(cosine > 0)) continue;
      if (scene.occluded(shadow_ray(point, sample.wi, sample.distance))) continue;
      const float factor =
          cosine / (3.14159f * static_cast<float>(sample.pdf) * static_cast<float>(draws));
      r += static_cast<float>(point.albedo.r * sample.radiance.r) * factor;
      g += static_cast<float>(point.albedo.g * sample.radiance.g) * factor;
      b += static_cast<float>(point.albedo.b * sample.radiance.b) * factor;
    }
  }
  return {r, g, b};
}

}  // namespace pt
