#pragma once

#include "pt/geometry/primitives.h"
#include "pt/geometry/surface_point.h"
#include "pt/scene/light.h"
#include "pt/scene/material.h"
#include "pt/scene/tracer.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace pt {

// Everything that light meets, in world space (right-handed, y up). Its members trace rays with any
// engine, and count them.
struct Scene {
  Primitives primitives;
  std::vector<int> material_of;  // for each primitive, an index into materials
  std::vector<Material> materials;
  std::vector<Light> lights;
  Tracer tracer;  // made for these primitives, after they are complete

  // The nearest surface within the ray's range.
  std::optional<Hit> closest(const Ray& ray) const;

  // Returns whether any surface lies within the ray's range.
  bool occluded(const Ray& ray) const;

  // The same for up to 32 rays, best from one point towards one light. Bit i is for ray i.
  std::uint32_t occluded(std::span<const Ray> rays) const;
};

// The surface that a ray met, as light transport sees it. `ray` is the ray that was hit.
SurfacePoint surface_point(const Scene& scene, const Ray& ray, const Hit& hit);

// The radiance of the sky along the unit `direction`, for a ray from a surface that leaves the
// scene. (Camera rays and indirect rays see black there.)
Rgb background(const Scene& scene, Vec3 direction);

// The rays that this thread has traced since it started, of all scenes.
struct RayCount {
  long long closest = 0;
  long long occluded = 0;
};
RayCount rays_traced();

// Adds rays that another process traced for this thread.
void count_rays(const RayCount& more);

}  // namespace pt
