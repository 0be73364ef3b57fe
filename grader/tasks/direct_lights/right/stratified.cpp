// right: rectangles are cut into as many strips as there are samples.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

namespace pt {

namespace {

// Strip i of n along u; other lights stay whole.
Light strip(const Light& light, int i, int n) {
  const auto* whole = std::get_if<RectangleLight>(&light);
  if (whole == nullptr) return light;
  RectangleLight part = *whole;
  part.center = whole->center + ((i + 0.5) / n - 0.5) * whole->u;
  part.u = whole->u / n;
  return part;
}

// The weight of one draw: strips are summed, draws of a whole light averaged.
double share(const Light& light, int n) {
  return std::holds_alternative<RectangleLight>(light) ? 1 : 1.0 / n;
}

}  // namespace

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (const Light& light : scene.lights) {
    const int draws = is_delta(light) ? 1 : samples;
    Rgb total;
    for (int i = 0; i < draws; ++i) {
      const Light part = strip(light, i, draws);
      const LightSample sample = sample_light(part, point.p, sampler);
      const Vec3 wi = point.frame.to_local(sample.wi);
      if (!(wi.z > 0)) continue;
      if (scene.occluded(shadow_ray(point, sample.wi, sample.distance))) continue;
      total += diffuse_f(point.albedo, wo, wi) * sample.radiance * wi.z / sample.pdf *
               share(light, draws);
    }
    sum += total;
  }
  return sum;
}

}  // namespace pt
