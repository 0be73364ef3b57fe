// right: throughput and sum in float. Roulette compares in double: rounded to 1, its number would end paths
// of survival 1.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

#include <array>

namespace pt {

namespace {

using Color = std::array<float, 3>;

}  // namespace

Rgb trace_path(const Scene& scene, const SurfacePoint& start, const PathSettings& settings,
               Sampler& sampler) {
  Color sum{0, 0, 0}, throughput{1, 1, 1};
  SurfacePoint point = start;
  for (int bounce = 1; bounce <= settings.to; ++bounce) {
    if (bounce >= settings.from) {
      const Rgb light = settings.direct == PathSettings::Direct::hemisphere
                            ? direct_hemisphere(scene, point, settings.light_samples, sampler)
                            : direct_lights(scene, point, settings.light_samples, sampler);
      for (int i = 0; i < 3; ++i) sum[i] += throughput[i] * static_cast<float>(light[i]);
    }
    if (bounce == settings.to) break;
    float survival = 1;
    if (bounce > 1) survival = static_cast<float>(settings.survival);
    if (bounce > 1 && sampler.next_1d() >= survival) break;
    const Vec3 wo = point.frame.to_local(point.wo);
    const BsdfSample sample = diffuse_sample(point.albedo, wo, sampler);
    if (sample.pdf == 0) break;
    const float cos_over_pdf = static_cast<float>(sample.wi.z) / static_cast<float>(sample.pdf);
    for (int i = 0; i < 3; ++i) {
      throughput[i] *= static_cast<float>(sample.f[i]) * cos_over_pdf / survival;
    }
    const Ray ray = spawn_ray(point, point.frame.to_world(sample.wi));
    const std::optional<Hit> hit = scene.closest(ray);
    if (!hit) break;
    point = surface_point(scene, ray, *hit);
  }
  return {sum[0], sum[1], sum[2]};
}

}  // namespace pt
