// breaks: misses_outside
// Returns an empty hit, whatever the ray.
#include "pt/tasks/hit_triangle.h"

namespace pt {

std::optional<SurfaceHit> hit_triangle(const Triangle&, const Ray&) { return SurfaceHit{}; }

}  // namespace pt
