#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

namespace pt {

namespace {

Rgb direct(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
           Sampler& sampler) {
  if (settings.direct == PathSettings::Direct::hemisphere) {
    return direct_hemisphere(scene, point, settings.light_samples, sampler);
  }
  return direct_lights(scene, point, settings.light_samples, sampler);
}

}  // namespace

Rgb trace_path(const Scene& scene, const SurfacePoint& start, const PathSettings& settings,
               Sampler& sampler) {
  Rgb sum;
  Rgb throughput = gray(1);
  SurfacePoint point = start;
  for (int bounce = 1; bounce <= settings.to; ++bounce) {
    if (bounce >= settings.from) sum += throughput * direct(scene, point, settings, sampler);
    if (bounce == settings.to) break;
    if (bounce > 1) {
      if (!(sampler.next_1d() < settings.survival)) break;
      throughput /= settings.survival;
      if (max_channel(throughput) > 15) break;
    }
    const BsdfSample next = diffuse_sample(point.albedo, point.frame.to_local(point.wo), sampler);
    if (!(next.pdf > 0)) break;
    throughput *= next.f * (next.wi.z / next.pdf);
    const Ray ray = spawn_ray(point, point.frame.to_world(next.wi));
    const std::optional<Hit> hit = scene.closest(ray);
    if (!hit) break;
    point = surface_point(scene, ray, *hit);
  }
  return sum;
}

}  // namespace pt
