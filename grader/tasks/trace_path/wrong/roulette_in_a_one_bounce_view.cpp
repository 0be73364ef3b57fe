// breaks: adds_up_the_bounces_asked_for
// A path that ends before the one bounce of the view adds the bounce where it ended.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

namespace pt {

Rgb trace_path(const Scene& scene, const SurfacePoint& start, const PathSettings& settings,
               Sampler& sampler) {
  Rgb sum;
  Rgb throughput = gray(1);
  SurfacePoint point = start;
  for (int bounce = 1; bounce <= settings.to; ++bounce) {
    if (bounce >= settings.from) {
      const bool looks_around = settings.direct == PathSettings::Direct::hemisphere;
      sum += throughput * (looks_around
                               ? direct_hemisphere(scene, point, settings.light_samples, sampler)
                               : direct_lights(scene, point, settings.light_samples, sampler));
    }
    const BsdfSample sample = diffuse_sample(point.albedo, point.frame.to_local(point.wo), sampler);
    if (!(sample.pdf > 0)) break;
    throughput *= sample.f * (sample.wi.z / sample.pdf);
    if (!(sampler.next_1d() < settings.survival)) {
      if (bounce < settings.from) sum += direct_lights(scene, point, 1, sampler);
      break;
    }
    throughput /= settings.survival;
    const Ray ray = spawn_ray(point, point.frame.to_world(sample.wi));
    const std::optional<Hit> hit = scene.closest(ray);
    if (!hit) break;
    point = surface_point(scene, ray, *hit);
  }
  return sum;
}

}  // namespace pt
