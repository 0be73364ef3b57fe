#include "pt/tasks/direct_lights.h"

#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <memory>
#include <vector>
namespace pt {
// Samples outside, lights inside; shadow rays of one round asked as a group.
Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  auto delta = std::make_unique<Rgb>(), area = std::make_unique<Rgb>();
  const Vec3 wo = point.frame.to_local(point.wo);
  auto one = [&](const Light& light) {
    const LightSample s = sample_light(light, point.p, sampler);
    const Vec3 wi = point.frame.to_local(s.wi);
    if (wi.z <= 0 || is_black(s.radiance)) return Rgb{};
    const std::vector<Ray> rays{shadow_ray(point, s.wi, s.distance)};
    if (scene.occluded(std::span(rays)) & 1) return Rgb{};
    return diffuse_f(point.albedo, wo, wi) * s.radiance * (wi.z / s.pdf);
  };
  for (const Light& light : scene.lights)
    if (is_delta(light)) *delta += one(light);
  for (int i = 0; i < samples; ++i)
    for (const Light& light : scene.lights)
      if (!is_delta(light)) *area += one(light);
  return *delta + *area / samples;
}
}  // namespace pt
