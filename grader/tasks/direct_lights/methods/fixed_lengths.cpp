// method: lengths that do not know the size of the scene: a ray starts 1e-5 off the surface, and ends 1e-4
// before the light
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

#ifndef REAL
#define REAL double
#endif

namespace pt {

namespace {

REAL sum_of(double a, double b) { return static_cast<REAL>(a) + static_cast<REAL>(b); }

Vec3 moved(Vec3 p, Vec3 by) { return {sum_of(p.x, by.x), sum_of(p.y, by.y), sum_of(p.z, by.z)}; }

}  // namespace

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  constexpr double kOffset = 1e-5, kGap = 1e-4;
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (const Light& light : scene.lights) {
    const int draws = is_delta(light) ? 1 : samples;
    for (int i = 0; i < draws; ++i) {
      const LightSample sample = sample_light(light, point.p, sampler);
      const Vec3 wi = point.frame.to_local(sample.wi);
      if (!(wi.z > 0)) continue;
      const Ray ray{moved(point.p, kOffset * point.n), moved(sample.wi, {}), 0,
                    sum_of(sample.distance, -kGap)};
      if (scene.occluded(ray)) continue;
      sum += diffuse_f(point.albedo, wo, wi) * sample.radiance * wi.z / sample.pdf / draws;
    }
  }
  return sum;
}

}  // namespace pt
