// breaks: casts_shadows
// All shadow rays to a sphere light go to its middle, so that it is hidden as a whole or not at all.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

namespace pt {

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (const Light& light : scene.lights) {
    const int draws = is_delta(light) ? 1 : samples;
    Rgb of_this_light;
    for (int i = 0; i < draws; ++i) {
      const LightSample sample = sample_light(light, point.p, sampler);
      const Vec3 wi = point.frame.to_local(sample.wi);
      if (!(wi.z > 0) || is_black(sample.radiance)) continue;
      Vec3 to = sample.wi;
      double way = sample.distance;
      if (const auto* ball = std::get_if<SphereLight>(&light)) {
        way = length(ball->center - point.p) - ball->radius;
        to = normalize(ball->center - point.p);
      }
      if (scene.occluded(shadow_ray(point, to, way))) continue;

      const Rgb f = diffuse_f(point.albedo, wo, wi);
      of_this_light += f * sample.radiance * (wi.z / sample.pdf);
    }
    sum += of_this_light / draws;
  }
  return sum;
}

}  // namespace pt
