// breaks: starts_off_the_surface
// The offset grows with the distance of the light, not with the numbers the point came from.
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
      const Ray ray{point.p + 1e-13 * std::min(1e3, sample.distance) * point.n, sample.wi, 0,
                    (1 - 1e-4) * sample.distance};
      if (scene.occluded(ray)) continue;
      total += diffuse_f(point.albedo, wo, wi) * sample.radiance * wi.z / sample.pdf;
    }
    sum += total / draws;
  }
  return sum;
}

}  // namespace pt
