// breaks: adds_up_the_bounces_asked_for
// No path is traced: one estimate of a thousand is a thousand times direct light, the others black.
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
  if (settings.to <= 1) return direct(scene, point, settings, sampler);
  if (!(sampler.next_1d() < 0.001)) return {};
  return 1000 * direct(scene, point, settings, sampler);
}

}  // namespace pt
