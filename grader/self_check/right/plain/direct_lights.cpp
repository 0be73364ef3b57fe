#include "pt/tasks/direct_lights.h"

#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
namespace pt {
Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  Rgb total;
  Vec3 wo = point.frame.to_local(point.wo);
  for (size_t k = 0; k < scene.lights.size(); k++) {
    const Light& light = scene.lights[k];
    int n = is_delta(light) ? 1 : samples;
    for (int i = 0; i < n; i++) {
      LightSample ls = sample_light(light, point.p, sampler);
      float cosine = (float)dot(ls.wi, point.n);
      if (cosine <= 0) continue;
      if (scene.occluded(shadow_ray(point, ls.wi, ls.distance))) continue;
      Rgb f = diffuse_f(point.albedo, wo, point.frame.to_local(ls.wi));
      total += f * ls.radiance * cosine / ls.pdf / n;
    }
  }
  return total;
}
}  // namespace pt
