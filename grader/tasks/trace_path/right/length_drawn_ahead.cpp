// right: the number of points of the path is drawn before it begins, with one number. It has the
// distribution that a number for each point would give it.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

#include <algorithm>
#include <cmath>

namespace pt {

namespace {

// Draws how often roulette lets the path go on: k times with probability (1 - survival) survival^k.
int times_it_goes_on(double survival, int most, Sampler& sampler) {
  if (survival >= 1) return most;
  const double times = std::log1p(-sampler.next_1d()) / std::log(survival);
  return static_cast<int>(std::min(times, static_cast<double>(most)));
}

}  // namespace

Rgb trace_path(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
               Sampler& sampler) {
  if (settings.from > settings.to) return {};
  const int last = std::min(settings.to, 2 + times_it_goes_on(settings.survival, 100, sampler));
  Rgb sum, throughput = gray(1);
  SurfacePoint here = point;
  for (int bounce = 1; bounce <= last; ++bounce) {
    if (bounce >= settings.from) {
      const int n = settings.light_samples;
      sum += throughput * (settings.direct == PathSettings::Direct::lights
                               ? direct_lights(scene, here, n, sampler)
                               : direct_hemisphere(scene, here, n, sampler));
    }
    if (bounce == last) break;
    const BsdfSample turn = diffuse_sample(here.albedo, here.frame.to_local(here.wo), sampler);
    const double chance = bounce > 1 ? settings.survival : 1;
    throughput *= turn.f * (turn.wi.z / turn.pdf / chance);
    const Ray ray = spawn_ray(here, here.frame.to_world(turn.wi));
    const std::optional<Hit> hit = scene.closest(ray);
    if (!hit) break;
    here = surface_point(scene, ray, *hit);
  }
  return sum;
}

}  // namespace pt
