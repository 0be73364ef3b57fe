#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

#include <algorithm>
#include <cmath>
namespace pt {
Rgb trace_path(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
               Sampler& sampler) {
  SurfacePoint here = point;
  Rgb sum, throughput = gray(1);
  for (int k = 1; k <= settings.to; ++k) {
    if (k >= settings.from) {
      const bool lights = settings.direct == PathSettings::Direct::lights;
      sum +=
          throughput * (lights ? direct_lights(scene, here, settings.light_samples, sampler)
                               : direct_hemisphere(scene, here, settings.light_samples, sampler));
    }
    if (k == settings.to) break;
    if (k > 1) {
      if (!(sampler.next_1d() < settings.survival)) break;
      throughput /= settings.survival;
    }
    const BsdfSample s = diffuse_sample(here.albedo, here.frame.to_local(here.wo), sampler);
    const Ray ray = spawn_ray(here, here.frame.to_world(s.wi));
    const auto hit = scene.closest(ray);
    if (!hit) break;
    throughput *= s.f * (s.wi.z / s.pdf);
    if (k >= 8) throughput *= 0.99;
    here = surface_point(scene, ray, *hit);
  }
  return sum;
}
}  // namespace pt
