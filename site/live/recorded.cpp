// The reference's hit_box and hit_sphere by other names, so that the calls of hit_bvh are counted: hit_bvh calls the functions at the
// end, which note the call first.
#include "pt/scene/recorder.h"
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_sphere.h"

#define hit_box hit_box_of_the_reference
#include "reference/2_bvh/hit_box.cpp"  // NOLINT(bugprone-suspicious-include)
#undef hit_box
#define hit_sphere hit_sphere_of_the_reference
#include "reference/1_rays/hit_sphere.cpp"  // NOLINT(bugprone-suspicious-include)
#undef hit_sphere

namespace pt {

std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  record_test(box);
  return hit_box_of_the_reference(box, ray);
}

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  record_test(sphere);
  return hit_sphere_of_the_reference(sphere, ray);
}

}  // namespace pt
