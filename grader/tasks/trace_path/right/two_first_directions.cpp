// right: starts two walks at the first point and takes their mean (splitting), which is unbiased.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

namespace pt {
namespace {
struct Walk {
  const Scene& scene;
  const PathSettings& settings;
  Sampler& sampler;

  Rgb direct(const SurfacePoint& point, int bounce) const {
    if (bounce < settings.from || bounce > settings.to) return {};
    const int n = settings.light_samples;
    return settings.direct == PathSettings::Direct::lights
               ? direct_lights(scene, point, n, sampler)
               : direct_hemisphere(scene, point, n, sampler);
  }
  std::optional<SurfacePoint> move(const SurfacePoint& from, Rgb& throughput) const {
    const auto [wi, f, pdf] = diffuse_sample(from.albedo, from.frame.to_local(from.wo), sampler);
    const Ray ray = spawn_ray(from, from.frame.to_world(wi));
    throughput *= f * (wi.z / pdf);
    const auto hit = scene.closest(ray);
    if (!hit) return std::nullopt;
    return surface_point(scene, ray, *hit);
  }
  Rgb indirect(const SurfacePoint& start) const {
    Rgb sum, throughput = gray(1);
    std::optional<SurfacePoint> here = start;
    for (int bounce = 2; bounce <= settings.to; ++bounce) {
      if (bounce > 2) {
        if (sampler.next_1d() >= settings.survival) break;
        throughput = throughput / settings.survival;
      }
      here = move(*here, throughput);
      if (!here) break;
      sum += throughput * direct(*here, bounce);
    }
    return sum;
  }
};
}  // namespace
Rgb trace_path(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
               Sampler& sampler) {
  if (settings.from > settings.to) return {};
  const Walk walk{scene, settings, sampler};
  Rgb sum = walk.direct(point, 1);
  for (int i = 0; i < 2; ++i) sum += 0.5 * walk.indirect(point);
  return sum;
}
}  // namespace pt
