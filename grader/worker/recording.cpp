// In the integrated worker, hit_bvh asks the submission's own tests of boxes and primitives, and
// the judge is told which ones were made. The linker (--wrap) sends every call from another file
// through these; the names are those that g++ and clang give to the functions in pt/tasks/. The
// submission could forge this record: the one that counts is taken where hit_bvh is judged by
// itself.
#include "grader/worker/serve.h"

namespace grader::worker {

std::optional<pt::Interval> real_hit_box(const pt::Box&, const pt::Ray&) asm(
    "__real__ZN2pt7hit_boxERKNS_3BoxERKNS_3RayE");
std::optional<pt::SurfaceHit> real_hit_triangle(const pt::Triangle&, const pt::Ray&) asm(
    "__real__ZN2pt12hit_triangleERKNS_8TriangleERKNS_3RayE");
std::optional<pt::SurfaceHit> real_hit_sphere(const pt::Sphere&, const pt::Ray&) asm(
    "__real__ZN2pt10hit_sphereERKNS_6SphereERKNS_3RayE");

std::optional<pt::Interval> hit_box(const pt::Box&, const pt::Ray&) asm(
    "__wrap__ZN2pt7hit_boxERKNS_3BoxERKNS_3RayE");
std::optional<pt::SurfaceHit> hit_triangle(const pt::Triangle&, const pt::Ray&) asm(
    "__wrap__ZN2pt12hit_triangleERKNS_8TriangleERKNS_3RayE");
std::optional<pt::SurfaceHit> hit_sphere(const pt::Sphere&, const pt::Ray&) asm(
    "__wrap__ZN2pt10hit_sphereERKNS_6SphereERKNS_3RayE");

std::optional<pt::Interval> hit_box(const pt::Box& box, const pt::Ray& ray) {
  if (remote::Tests* tests = tests_of_this_call()) tests->boxes.push_back(box);
  return real_hit_box(box, ray);
}

std::optional<pt::SurfaceHit> hit_triangle(const pt::Triangle& triangle, const pt::Ray& ray) {
  if (remote::Tests* tests = tests_of_this_call()) tests->triangles.push_back(triangle);
  return real_hit_triangle(triangle, ray);
}

std::optional<pt::SurfaceHit> hit_sphere(const pt::Sphere& sphere, const pt::Ray& ray) {
  if (remote::Tests* tests = tests_of_this_call()) tests->spheres.push_back(sphere);
  return real_hit_sphere(sphere, ray);
}

}  // namespace grader::worker
