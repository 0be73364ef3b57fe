#include "pt/tasks/direct_lights.h"

#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"

namespace pt {

namespace {

// One draw of what a light gives. The shadow ray comes last: it is what costs time.
Rgb estimate(const Scene& scene, const SurfacePoint& point, const Light& light, Sampler& sampler) {
  const LightSample sample = sample_light(light, point.p, sampler);
  const Vec3 wo = point.frame.to_local(point.wo);
  const Vec3 wi = point.frame.to_local(sample.wi);
  if (!(wi.z > 0) || is_black(sample.radiance)) return {};
  if (scene.occluded(shadow_ray(point, sample.wi, sample.distance))) return {};
  return diffuse_f(point.albedo, wo, wi) * sample.radiance * (wi.z / sample.pdf);
}

}  // namespace

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  Rgb sum;
  for (const Light& light : scene.lights) {
    // All draws of a delta light are the same one.
    const int draws = is_delta(light) ? 1 : samples;
    Rgb of_this_light;
    for (int i = 0; i < draws; ++i) of_this_light += estimate(scene, point, light, sampler);
    sum += of_this_light / draws;
  }
  return sum;
}

}  // namespace pt
