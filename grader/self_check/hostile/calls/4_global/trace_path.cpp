// Hands the work on to the renderer's radiance, and that to nobody.
#include "pt/tasks/trace_path.h"

#include "pt/geometry/spawn_ray.h"

namespace pt {

Rgb radiance(const Scene&, const Ray&, const PathSettings&, Sampler&);

Rgb trace_path(const Scene& scene, const SurfacePoint& point, const PathSettings& settings,
               Sampler& sampler) {
  return radiance(scene, spawn_ray(point, point.n), settings, sampler);
}

}  // namespace pt
