// right: one draw of each light after the other, in an order that is shuffled for each sample.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

#include <numeric>
#include <utility>
#include <vector>

namespace pt {

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  std::vector<std::size_t> order(scene.lights.size());
  std::iota(order.begin(), order.end(), 0);
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    for (std::size_t k = order.size(); k > 1; --k) {
      const double other = sampler.next_1d() * static_cast<double>(k);
      std::swap(order[k - 1], order[static_cast<std::size_t>(other)]);
    }
    for (const std::size_t k : order) {
      const LightSample sample = sample_light(scene.lights[k], point.p, sampler);
      const Vec3 wi = point.frame.to_local(sample.wi);
      if (!(wi.z > 0)) continue;
      if (scene.occluded(shadow_ray(point, sample.wi, sample.distance))) continue;
      sum += diffuse_f(point.albedo, wo, wi) * sample.radiance * (wi.z / sample.pdf / samples);
    }
  }
  return sum;
}

}  // namespace pt
