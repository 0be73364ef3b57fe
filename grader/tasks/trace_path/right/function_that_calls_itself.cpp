// right: a std::function that calls itself; the coin says who dies.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

#include <functional>

namespace pt {

Rgb trace_path(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
               Sampler& sampler) {
  std::function<Rgb(const SurfacePoint&, int)> radiance_from = [&](const SurfacePoint& x,
                                                                   int bounce) -> Rgb {
    if (bounce > settings.to) return {};
    Rgb radiance;
    if (bounce >= settings.from) {
      radiance = settings.direct == PathSettings::Direct::lights
                     ? direct_lights(scene, x, settings.light_samples, sampler)
                     : direct_hemisphere(scene, x, settings.light_samples, sampler);
    }
    const bool first = bounce == 1;
    if (bounce == settings.to) return radiance;
    if (!first && sampler.next_1d() < 1 - settings.survival) return radiance;
    const auto [wi, f, pdf] = diffuse_sample(x.albedo, x.frame.to_local(x.wo), sampler);
    if (!(pdf > 0)) return radiance;
    const Ray ray = spawn_ray(x, x.frame.to_world(wi));
    if (const auto hit = scene.closest(ray)) {
      Rgb found = f * radiance_from(surface_point(scene, ray, *hit), bounce + 1) * (wi.z / pdf);
      if (!first) found /= settings.survival;
      radiance += found;
    }
    return radiance;
  };
  return radiance_from(point, 1);
}

}  // namespace pt
