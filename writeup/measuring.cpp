// In the worker of a boxed submission the linker (--wrap) sends every call of these tasks from another
// file through here: tests are counted, and direct light goes by way of the tape on which the bounces
// of a path are taken apart.
#include "pt/render/bounces_apart.h"
#include "pt/render/test_count.h"
#include "pt/tasks/direct_hemisphere.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_sphere.h"
#include "pt/tasks/hit_triangle.h"

namespace writeup {

using pt::Ray;

#define FIRSTLIGHT_COUNTED(slug, Result, Shape, counter)                                     \
  std::optional<pt::Result> real_##slug(const pt::Shape&,                                    \
                                        const Ray&) asm("__real_" FIRSTLIGHT_SYMBOL_##slug); \
  std::optional<pt::Result> slug(const pt::Shape&,                                           \
                                 const Ray&) asm("__wrap_" FIRSTLIGHT_SYMBOL_##slug);        \
  std::optional<pt::Result> slug(const pt::Shape& shape, const Ray& ray) {                   \
    ++pt::test_count.counter;                                                                \
    return real_##slug(shape, ray);                                                          \
  }
FIRSTLIGHT_COUNTED(hit_box, Interval, Box, boxes)
FIRSTLIGHT_COUNTED(hit_triangle, SurfaceHit, Triangle, triangles)
FIRSTLIGHT_COUNTED(hit_sphere, SurfaceHit, Sphere, spheres)

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
