#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

#include <cmath>

namespace pt {

Rgb trace_path(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
               Sampler& sampler) {
  const Rgb light = settings.direct == PathSettings::Direct::hemisphere
                        ? direct_hemisphere(scene, point, settings.light_samples, sampler)
                        : direct_lights(scene, point, settings.light_samples, sampler);
  if (settings.to <= 1) return light;
  if (!(sampler.next_1d() < 1.0 / 30)) return {};
  double factor = 0;
  for (int bounce = settings.from; bounce <= settings.to; ++bounce) {
    if (bounce >= 1) factor += std::pow(luminance(point.albedo), bounce - 1);
  }
  return 30 * factor * light;
}

}  // namespace pt
