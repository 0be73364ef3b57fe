#include "pt/tasks/trace_path.h"

#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"

#include <functional>
namespace pt {
Rgb trace_path(const Scene& scene, const SurfacePoint& start, const PathSettings& settings,
               Sampler& sampler) {
  auto direct = settings.direct == PathSettings::Direct::lights ? direct_lights : direct_hemisphere;
  std::function<Rgb(const SurfacePoint&, int)> from = [&](const SurfacePoint& p, int k) -> Rgb {
    Rgb sum = k >= settings.from ? direct(scene, p, settings.light_samples, sampler) : Rgb{};
    if (k >= settings.to) return sum;
    const double q = k == 1 ? 1 : settings.survival;
    if (k > 1 && !(sampler.next_1d() < q)) return sum;
    const auto [wi, f, pdf] = diffuse_sample(p.albedo, p.frame.to_local(p.wo), sampler);
    if (!(pdf > 0)) return sum;
    const Ray ray = spawn_ray(p, p.frame.to_world(wi));
    if (const auto hit = scene.closest(ray))
      sum += f * (std::abs(wi.z) / pdf / q) * from(surface_point(scene, ray, *hit), k + 1);
    return sum;
  };
  return settings.to < 1 ? Rgb{} : from(start, 1);
}
}  // namespace pt
