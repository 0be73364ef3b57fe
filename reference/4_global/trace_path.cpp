#include "pt/tasks/trace_path.h"

#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"

#include <cmath>

namespace pt {

namespace {

Rgb direct(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
           Sampler& sampler) {
  return settings.direct == PathSettings::Direct::hemisphere
             ? direct_hemisphere(scene, point, settings.light_samples, sampler)
             : direct_lights(scene, point, settings.light_samples, sampler);
}

}  // namespace

Rgb trace_path(const Scene& scene, const SurfacePoint& start, const PathSettings& settings,
               Sampler& sampler) {
  // The sum of T_k D_k over the bounces k = from, ..., to. D_k is the direct light at point k, the
  // first being `start`. The throughput T_k is the product of f cos / pdf over the directions chosen
  // before point k, divided by the chance to survive at each point between the first and point k.
  Rgb sum;
  Rgb throughput = gray(1);  // the part of the light at `point` that reaches `start`
  SurfacePoint point = start;
  for (int bounce = 1; bounce <= settings.to; ++bounce) {
    if (bounce >= settings.from) sum += throughput * direct(scene, point, settings, sampler);
    if (bounce == settings.to) break;

    // Russian roulette, at every point except the first: a path that goes on also represents the
    // paths that end here.
    if (bounce > 1) {
      if (!(sampler.next_1d() < settings.survival)) break;
      throughput /= settings.survival;
    }

    const Vec3 wo = point.frame.to_local(point.wo);
    const BsdfSample next = diffuse_sample(point.albedo, wo, sampler);
    if (!(next.pdf > 0)) break;  // a direction along the surface brings no light
    throughput *= next.f * (std::abs(next.wi.z) / next.pdf);

    const Ray ray = spawn_ray(point, point.frame.to_world(next.wi));
    const std::optional<Hit> hit = scene.closest(ray);
    if (!hit) break;
    point = surface_point(scene, ray, *hit);
  }
  return sum;
}

}  // namespace pt
