// breaks: keeps_light_on_its_side
// The absolute cosine lets light through the surface.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/direct_lights.h"

namespace pt {

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  Rgb sum;
  for (const Light& light : scene.lights) {
    const int draws = is_delta(light) ? 1 : samples;
    Rgb total;
    for (int i = 0; i < draws; ++i) {
      const LightSample sample = sample_light(light, point.p, sampler);
      const Vec3 wi = point.frame.to_local(sample.wi);
      if (scene.occluded(shadow_ray(point, sample.wi, sample.distance))) continue;
      total += point.albedo / kPi * sample.radiance * std::abs(wi.z) / sample.pdf;
    }
    sum += total / draws;
  }
  return sum;
}

}  // namespace pt
