// In a worker that runs a submission in the box, the linker (--wrap) sends every call of these tasks from another file
// through here, where tests are counted.
#include "pt/render/test_count.h"
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

}  // namespace writeup
