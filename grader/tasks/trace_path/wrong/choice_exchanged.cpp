// breaks: starts_with_direct_light
// Hemisphere sampling and light sampling are exchanged.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

namespace pt {

namespace {

Rgb direct(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
           Sampler& sampler) {
  if (settings.direct != PathSettings::Direct::hemisphere) {
    return direct_hemisphere(scene, point, settings.light_samples, sampler);
  }
  return direct_lights(scene, point, settings.light_samples, sampler);
}

// Estimates the light that leaves `point` towards where the path comes from, by `bounce` bounces and more.
Rgb from_bounce(int bounce, const Scene& scene, const SurfacePoint& point,
                const PathSettings& settings, Sampler& sampler) {
  Rgb sum;
  if (bounce >= settings.from) sum += direct(scene, point, settings, sampler);
  if (bounce >= settings.to) return sum;

  double chance = 1;
  if (bounce > 1) {
    chance = settings.survival;
    if (sampler.next_1d() >= chance) return sum;
  }

  const BsdfSample sample = diffuse_sample(point.albedo, point.frame.to_local(point.wo), sampler);
  if (sample.pdf <= 0) return sum;
  const Ray ray = spawn_ray(point, point.frame.to_world(sample.wi));
  const std::optional<Hit> hit = scene.closest(ray);
  if (!hit) return sum;
  const SurfacePoint next = surface_point(scene, ray, *hit);
  const Rgb throughput = sample.f * (sample.wi.z / sample.pdf / chance);
  return sum + throughput * from_bounce(bounce + 1, scene, next, settings, sampler);
}

}  // namespace

Rgb trace_path(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
               Sampler& sampler) {
  if (settings.to < 1) return {};
  return from_bounce(1, scene, point, settings, sampler);
}

}  // namespace pt
