// right: a loop; after three bounces, survives by how bright the throughput is, .05 to .95.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

#include <algorithm>

namespace pt {

Rgb trace_path(const Scene& scene, const SurfacePoint& start, const PathSettings& settings,
               Sampler& sampler) {
  Rgb radiance, throughput = gray(1);
  SurfacePoint x = start;
  int bounce = 1;
  while (bounce <= settings.to) {
    if (bounce >= settings.from) {
      radiance += throughput * (settings.direct == PathSettings::Direct::lights
                                    ? direct_lights(scene, x, settings.light_samples, sampler)
                                    : direct_hemisphere(scene, x, settings.light_samples, sampler));
    }
    if (bounce > 3) {
      const double survival = std::clamp(luminance(throughput), 0.05, 0.95);
      if (sampler.next_1d() > survival) return radiance;
      throughput = throughput / survival;
    }
    const BsdfSample s = diffuse_sample(x.albedo, x.frame.to_local(x.wo), sampler);
    if (s.pdf <= 0) return radiance;
    const Ray ray = spawn_ray(x, x.frame.to_world(s.wi));
    const auto hit = scene.closest(ray);
    if (!hit) return radiance;
    throughput *= s.f * s.wi.z / s.pdf;
    x = surface_point(scene, ray, *hit);
    ++bounce;
  }
  return radiance;
}

}  // namespace pt
