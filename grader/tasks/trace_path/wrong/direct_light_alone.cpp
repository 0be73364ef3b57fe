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
  return settings.to < 1 ? Rgb{} : direct(scene, point, settings, sampler);
}

}  // namespace pt
