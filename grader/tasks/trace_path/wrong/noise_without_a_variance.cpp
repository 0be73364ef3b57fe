// breaks: matches_the_furnace
// No path is traced: direct light times a random number of mean 1 whose variance is infinite.
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/trace_path.h"

#include <cmath>

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
  return light * (0.1 * std::pow(1 - sampler.next_1d(), -0.9));
}

}  // namespace pt
