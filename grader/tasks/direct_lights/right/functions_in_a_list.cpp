// right: the draws come from functions in a list, each with a sampler of its own that is seeded by
// a number drawn from the one given, and are added up at the end.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

#include <functional>
#include <numeric>
#include <vector>

namespace pt {

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  std::vector<std::function<Rgb()>> mean_of_light;
  for (const Light& light : scene.lights) {
    Sampler own(static_cast<std::uint64_t>(sampler.next_1d() * 0x1p53));
    mean_of_light.push_back([&scene, &point, &light, samples, own]() mutable {
      std::vector<Rgb> found(is_delta(light) ? 1 : static_cast<std::size_t>(samples));
      for (Rgb& one : found) {
        const LightSample sample = sample_light(light, point.p, own);
        const Vec3 wi = point.frame.to_local(sample.wi);
        if (!(wi.z > 0) || scene.occluded(shadow_ray(point, sample.wi, sample.distance))) continue;
        one = diffuse_f(point.albedo, point.frame.to_local(point.wo), wi) * sample.radiance *
              (wi.z / sample.pdf);
      }
      return std::accumulate(found.begin(), found.end(), Rgb{}) / static_cast<double>(found.size());
    });
  }
  Rgb sum;
  for (const auto& mean : mean_of_light) sum += mean();
  return sum;
}

}  // namespace pt
