// right: each draw of an area light is one of two candidates, chosen by what it brings without its
// shadow, so that only one shadow ray is sent (Talbot, Cline and Egbert 2005, Importance Resampling).
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

namespace pt {

namespace {

struct Candidate {
  Vec3 wi;
  double distance = 0;
  Rgb light;  // f L cos / pdf, without a shadow
};

struct Draws {
  const Scene& scene;
  const SurfacePoint& point;
  Sampler& sampler;

  Candidate candidate(const Light& light) const {
    const LightSample sample = sample_light(light, point.p, sampler);
    const Vec3 wo = point.frame.to_local(point.wo), wi = point.frame.to_local(sample.wi);
    if (!(wi.z > 0)) return {};
    const Rgb f = diffuse_f(point.albedo, wo, wi);
    return {sample.wi, sample.distance, f * sample.radiance * (wi.z / sample.pdf)};
  }

  Rgb seen(const Candidate& one) const {
    if (is_black(one.light)) return {};
    return scene.occluded(shadow_ray(point, one.wi, one.distance)) ? Rgb{} : one.light;
  }

  // The mean of the candidates' sizes over the size of the chosen one makes the draw unbiased.
  Rgb resampled(const Light& light) const {
    const Candidate a = candidate(light), b = candidate(light);
    const double of_a = max_channel(a.light), both = of_a + max_channel(b.light);
    if (!(both > 0)) return {};
    const Candidate& chosen = sampler.next_1d() * both < of_a ? a : b;
    if (is_black(chosen.light)) return {};
    return seen(chosen) * (both / 2 / max_channel(chosen.light));
  }
};

}  // namespace

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  const Draws draws{scene, point, sampler};
  Rgb sum;
  for (const Light& light : scene.lights) {
    if (is_delta(light)) {
      sum += draws.seen(draws.candidate(light));
      continue;
    }
    for (int i = 0; i < samples; ++i) sum += draws.resampled(light) / samples;
  }
  return sum;
}

}  // namespace pt
