// Divides a whole number by zero.
#include "pt/tasks/hit_sphere.h"

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray&) {
  volatile int none = sphere.radius > 0 ? 0 : 1;
  return SurfaceHit{static_cast<double>(17 / none), {0, 0, 1}};
}

}  // namespace pt
