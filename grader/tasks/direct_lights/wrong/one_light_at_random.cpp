// breaks: adds_the_lights_up
// Samples one light, chosen at random, and does not multiply by the number of lights.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

namespace pt {

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  if (!scene.lights.empty()) {
    const double position = sampler.next_1d() * static_cast<double>(scene.lights.size());
    const Light& light = scene.lights[static_cast<std::size_t>(position)];
    const int draws = is_delta(light) ? 1 : samples;
    Rgb total;
    for (int i = 0; i < draws; ++i) {
      const LightSample sample = sample_light(light, point.p, sampler);
      const Vec3 wi = point.frame.to_local(sample.wi);
      if (!(wi.z > 0)) continue;
      if (scene.occluded(shadow_ray(point, sample.wi, sample.distance))) continue;
      total += diffuse_f(point.albedo, wo, wi) * sample.radiance * wi.z / sample.pdf;
    }
    sum += total / draws;
  }
  return sum;
}

}  // namespace pt
