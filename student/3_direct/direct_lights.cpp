#include "pt/tasks/direct_lights.h"

#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/todo.h"

namespace pt {

namespace {

// Helper functions of your own go here: nothing outside this file sees them.

}  // namespace

// TODO: ask each light for directions towards it, and sum what arrives unhindered and is reflected.
Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  todo("direct_lights");
  return {};
}

}  // namespace pt
