#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

#include <algorithm>
#include <cmath>
#include <vector>
namespace pt {
Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb total;
  for (const Light& light : scene.lights) {
    const int n = is_delta(light) ? 1 : samples;
    Rgb sum;
    for (int i = 0; i < n; ++i) {
      LightSample s = sample_light(light, point.p, sampler);
      const Vec3 wi = point.frame.to_local(s.wi);
      if (!(wi.z > 0) || is_black(s.radiance)) continue;
      if (s.delta && dot(point.geometric_normal, s.wi) < 0) continue;
      if (scene.occluded(shadow_ray(point, s.wi, s.distance))) continue;
      sum += diffuse_f(point.albedo, wo, wi) * s.radiance * (wi.z / s.pdf);
    }
    total += sum / n;
  }
  return total;
}
}  // namespace pt
