// hit_sphere of the worker in session_test: the radius chooses its behaviour.
#include "pt/tasks/hit_sphere.h"

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray&) {
  if (sphere.radius == 2) __builtin_trap();
  const volatile bool hangs = sphere.radius == 3;
  while (hangs) continue;
  return std::nullopt;
}

}  // namespace pt
