#pragma once

#include "pt/render/radiance.h"
#include "pt/tasks/trace_path.h"

namespace pt {

// The common part of the implementations `path`, `recorded` and `apart` of radiance().
inline Rgb common_radiance(const Scene& scene, const Ray& ray, const PathSettings& settings,
                           Sampler& sampler) {
  const std::optional<Hit> hit = scene.closest(ray);
  if (!hit) return {};
  if (settings.show_normals) {
    return 0.5 * Rgb{hit->n.x + 1, hit->n.y + 1, hit->n.z + 1};
  }
  const SurfacePoint point = surface_point(scene, ray, *hit);
  Rgb sum;
  if (settings.from <= 0) sum += point.emission;
  if (settings.to >= 1) sum += trace_path(scene, point, settings, sampler);
  return sum;
}

}  // namespace pt
