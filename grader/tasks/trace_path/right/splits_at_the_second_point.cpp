// right: from the second point, two branches go on, each with half of the light (splitting). The ends
// of all branches are in a list, and roulette decides for each of them.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

#include <deque>

namespace pt {

namespace {

struct End {
  SurfacePoint point;
  int bounce = 1;
  Rgb throughput = gray(1);
};

Rgb direct(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
           Sampler& sampler) {
  return settings.direct == PathSettings::Direct::lights
             ? direct_lights(scene, point, settings.light_samples, sampler)
             : direct_hemisphere(scene, point, settings.light_samples, sampler);
}

}  // namespace

Rgb trace_path(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
               Sampler& sampler) {
  if (settings.to < 1 || settings.from > settings.to) return {};
  std::deque<End> ends{{point}};
  Rgb sum;
  while (!ends.empty()) {
    const End end = ends.front();
    ends.pop_front();
    if (end.bounce >= settings.from) {
      sum += end.throughput * direct(scene, end.point, settings, sampler);
    }
    if (end.bounce == settings.to) continue;
    const double chance = end.bounce > 1 ? settings.survival : 1;
    const int branches = end.bounce == 2 ? 2 : 1;
    const Vec3 wo = end.point.frame.to_local(end.point.wo);
    for (int i = 0; i < branches; ++i) {
      if (chance < 1 && sampler.next_1d() >= chance) continue;
      const BsdfSample turn = diffuse_sample(end.point.albedo, wo, sampler);
      const Ray ray = spawn_ray(end.point, end.point.frame.to_world(turn.wi));
      const std::optional<Hit> hit = scene.closest(ray);
      if (!hit) continue;
      const Rgb part = turn.f * (turn.wi.z / turn.pdf / chance / branches);
      ends.push_back({surface_point(scene, ray, *hit), end.bounce + 1, end.throughput * part});
    }
  }
  return sum;
}

}  // namespace pt
