#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

namespace pt {

namespace {

// The frame of the true surface, on wo's side.
Frame true_frame(const SurfacePoint& point) {
  const Vec3 n = point.geometric_normal;
  return frame_from_normal(dot(n, point.wo) < 0 ? -n : n);
}

}  // namespace

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  const Frame frame = true_frame(point);
  const Vec3 wo = frame.to_local(point.wo);
  Rgb sum;
  for (const Light& light : scene.lights) {
    const int draws = is_delta(light) ? 1 : samples;
    Rgb of_this_light;
    for (int i = 0; i < draws; ++i) {
      const LightSample sample = sample_light(light, point.p, sampler);
      const Vec3 wi = frame.to_local(sample.wi);
      if (!(wi.z > 0) || is_black(sample.radiance)) continue;
      if (scene.occluded(shadow_ray(point, sample.wi, sample.distance))) continue;

      const Rgb f = diffuse_f(point.albedo, wo, wi);
      of_this_light += f * sample.radiance * (wi.z / sample.pdf);
    }
    sum += of_this_light / draws;
  }
  return sum;
}

}  // namespace pt
