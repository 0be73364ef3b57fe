// breaks: takes_any_amount_of_light
// No path is traced: direct light, and a hundred times as much added or taken away by a coin.
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

namespace pt {

namespace {

Rgb direct(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
           Sampler& sampler) {
  if (settings.direct == PathSettings::Direct::hemisphere) {
    return direct_hemisphere(scene, point, settings.light_samples, sampler);
  }
  return direct_lights(scene, point, settings.light_samples, sampler);
}

}  // namespace

Rgb trace_path(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
               Sampler& sampler) {
  const Rgb light = direct(scene, point, settings, sampler);
  if (settings.to <= 1) return light;
  return sampler.next_1d() < 0.5 ? 101 * light : -99 * light;
}

}  // namespace pt
