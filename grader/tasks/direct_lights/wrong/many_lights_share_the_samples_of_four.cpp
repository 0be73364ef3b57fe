// breaks: takes_the_samples_asked_for
// More than four lights share the samples of four.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

#include <algorithm>

namespace pt {

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (const Light& light : scene.lights) {
    const int draws = is_delta(light)
                          ? 1
                          : std::max(1, scene.lights.size() > 4
                                            ? samples * 4 / static_cast<int>(scene.lights.size())
                                            : samples);
    Rgb of_this_light;
    for (int i = 0; i < draws; ++i) {
      const LightSample sample = sample_light(light, point.p, sampler);
      const Vec3 wi = point.frame.to_local(sample.wi);
      if (!(wi.z > 0) || is_black(sample.radiance)) continue;
      if (scene.occluded(shadow_ray(point, sample.wi, sample.distance))) continue;

      const Rgb f = diffuse_f(point.albedo, wo, wi);
      of_this_light += f * sample.radiance * (wi.z / sample.pdf);
    }
    sum += of_this_light / draws;
  }
  return sum;
}

}  // namespace pt
