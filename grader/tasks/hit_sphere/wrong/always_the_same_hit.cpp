// breaks: misses_beside_the_sphere
// Returns an empty hit, whatever the ray.
#include "pt/tasks/hit_sphere.h"

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere&, const Ray&) { return SurfaceHit{}; }

}  // namespace pt
