// Includes the decision of the fast engine, which is whole in a header.
#include "pt/tasks/hit_triangle.h"

#include "pt/accel/exact_hit.h"

namespace pt {

std::optional<SurfaceHit> hit_triangle(const Triangle&, const Ray&) { return std::nullopt; }

}  // namespace pt
