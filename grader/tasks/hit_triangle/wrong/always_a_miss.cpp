#include "pt/tasks/hit_triangle.h"

namespace pt {

std::optional<SurfaceHit> hit_triangle(const Triangle&, const Ray&) { return {}; }

}  // namespace pt
