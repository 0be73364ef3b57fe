// breaks: takes_lights_of_any_brightness
// The sum of all lights is clamped, so that a picture has no huge values.
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
    Rgb total;
    for (int i = 0; i < draws; ++i) {
      const LightSample sample = sample_light(light, point.p, sampler);
      const Vec3 wi = point.frame.to_local(sample.wi);
      if (!(wi.z > 0)) continue;
      const Ray ray = shadow_ray(point, sample.wi, sample.distance);
      if (scene.occluded(ray)) continue;
      total += diffuse_f(point.albedo, wo, wi) * sample.radiance * wi.z / sample.pdf;
    }
    sum += total / draws;
  }
  return {std::min(sum.r, 1e3), std::min(sum.g, 1e3), std::min(sum.b, 1e3)};
}

}  // namespace pt
