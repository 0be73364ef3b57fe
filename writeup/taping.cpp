// In the worker of a boxed submission the linker (--wrap) sends every call of these tasks from another
// file through here: direct light goes by way of the tape on which the bounces of a path are taken apart.
#include "pt/render/bounces_apart.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"

namespace writeup {

#define FIRSTLIGHT_TAPED(slug)                                                     \
  pt::Rgb real_##slug(const pt::Scene&, const pt::SurfacePoint&, int,              \
                      pt::Sampler&) asm("__real_" FIRSTLIGHT_SYMBOL_##slug);       \
  pt::Rgb slug(const pt::Scene&, const pt::SurfacePoint&, int,                     \
               pt::Sampler&) asm("__wrap_" FIRSTLIGHT_SYMBOL_##slug);              \
  pt::Rgb slug(const pt::Scene& scene, const pt::SurfacePoint& point, int samples, \
               pt::Sampler& sampler) {                                             \
    return pt::direct_by_tape(real_##slug, scene, point, samples, sampler);        \
  }
FIRSTLIGHT_TAPED(direct_lights)
FIRSTLIGHT_TAPED(direct_hemisphere)

}  // namespace writeup
