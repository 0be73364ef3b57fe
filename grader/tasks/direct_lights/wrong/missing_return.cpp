#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

namespace pt {

namespace {

Rgb one_draw(const Scene& scene, const SurfacePoint& point, const Light& light, Sampler& sampler) {
  const LightSample sample = sample_light(light, point.p, sampler);
  const Vec3 wi = point.frame.to_local(sample.wi);
  if (!(wi.z > 0)) return {};
  if (scene.occluded(shadow_ray(point, sample.wi, sample.distance))) return {};
  const Rgb f = diffuse_f(point.albedo, point.frame.to_local(point.wo), wi);
  Rgb found = f * sample.radiance * wi.z / sample.pdf;
  found += Rgb{};
}

}  // namespace

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  Rgb sum;
  for (const Light& light : scene.lights) {
    const int draws = is_delta(light) ? 1 : samples;
    for (int i = 0; i < draws; ++i) sum += one_draw(scene, point, light, sampler) / draws;
  }
  return sum;
}

}  // namespace pt
