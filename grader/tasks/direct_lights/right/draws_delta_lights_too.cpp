// right: the mean of as many draws for a delta light as for any other, which only costs time
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

namespace pt {

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (const Light& light : scene.lights) {
    for (int i = 0; i < samples; ++i) {
      const LightSample sample = sample_light(light, point.p, sampler);
      const Vec3 wi = point.frame.to_local(sample.wi);
      if (!(wi.z > 0) || scene.occluded(shadow_ray(point, sample.wi, sample.distance))) continue;
      sum += diffuse_f(point.albedo, wo, wi) * sample.radiance * wi.z / sample.pdf / samples;
    }
  }
  return sum;
}

}  // namespace pt
