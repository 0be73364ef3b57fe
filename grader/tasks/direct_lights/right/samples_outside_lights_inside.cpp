// right: the loop over the samples outside, the one over the lights inside.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

namespace pt {

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    for (const Light& light : scene.lights) {
      const LightSample sample = sample_light(light, point.p, sampler);
      const double cosine = dot(sample.wi, point.n);
      if (cosine <= 0 || scene.occluded(shadow_ray(point, sample.wi, sample.distance))) continue;
      const Vec3 wi = point.frame.to_local(sample.wi);
      sum += diffuse_f(point.albedo, wo, wi) * sample.radiance * (cosine / sample.pdf) / samples;
    }
  }
  return sum;
}

}  // namespace pt
