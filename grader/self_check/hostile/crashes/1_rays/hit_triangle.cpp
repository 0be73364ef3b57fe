// Ends without a return.
#include "pt/tasks/hit_triangle.h"

namespace pt {

std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  const double along = dot(triangle.p0 - ray.origin, ray.direction);
  if (along == 0.125) return std::nullopt;
}

}  // namespace pt
