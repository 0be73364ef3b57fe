// The worker's end: in the integrated worker, hit_bvh calls the submission's own tests of boxes and primitives, and
// the judge is told which ones were made. The linker (--wrap) sends every call from another file
// through these; their names come from the build. The
// submission could forge this record: the one that counts is taken where hit_bvh is judged by
// itself.
#include "grader/wire/serve.h"

namespace grader::wire {

std::optional<pt::Interval> real_hit_box(const pt::Box&,
                                         const pt::Ray&) asm("__real_" FIRSTLIGHT_SYMBOL_hit_box);
std::optional<pt::SurfaceHit> real_hit_triangle(const pt::Triangle&, const pt::Ray&) asm(
    "__real_" FIRSTLIGHT_SYMBOL_hit_triangle);
std::optional<pt::SurfaceHit> real_hit_sphere(const pt::Sphere&, const pt::Ray&) asm(
    "__real_" FIRSTLIGHT_SYMBOL_hit_sphere);

std::optional<pt::Interval> hit_box(const pt::Box&,
                                    const pt::Ray&) asm("__wrap_" FIRSTLIGHT_SYMBOL_hit_box);
std::optional<pt::SurfaceHit> hit_triangle(const pt::Triangle&, const pt::Ray&) asm(
    "__wrap_" FIRSTLIGHT_SYMBOL_hit_triangle);
std::optional<pt::SurfaceHit> hit_sphere(const pt::Sphere&, const pt::Ray&) asm(
    "__wrap_" FIRSTLIGHT_SYMBOL_hit_sphere);

std::optional<pt::Interval> hit_box(const pt::Box& box, const pt::Ray& ray) {
  if (Tests* tests = tests_of_this_call()) tests->boxes.push_back(box);
  return real_hit_box(box, ray);
}

std::optional<pt::SurfaceHit> hit_triangle(const pt::Triangle& triangle, const pt::Ray& ray) {
  if (Tests* tests = tests_of_this_call()) tests->triangles.push_back(triangle);
  return real_hit_triangle(triangle, ray);
}

std::optional<pt::SurfaceHit> hit_sphere(const pt::Sphere& sphere, const pt::Ray& ray) {
  if (Tests* tests = tests_of_this_call()) tests->spheres.push_back(sphere);
  return real_hit_sphere(sphere, ray);
}

}  // namespace grader::wire
