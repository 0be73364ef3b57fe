#include "pt/tasks/direct_hemisphere.h"

#include "pt/geometry/spawn_ray.h"
#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/todo.h"

namespace pt {

namespace {

// Helper functions of your own go here: nothing outside this file sees them.

}  // namespace

// TODO: look in `samples` uniform directions over the surface and average what they reflect.
Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  todo("direct_hemisphere");
  return {};
}

}  // namespace pt
