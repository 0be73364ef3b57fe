// Writes where it must not.
#include "pt/tasks/hit_sphere.h"

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray&) {
  volatile int* volatile nowhere = nullptr;
  *nowhere = static_cast<int>(sphere.radius);
  return std::nullopt;
}

}  // namespace pt
