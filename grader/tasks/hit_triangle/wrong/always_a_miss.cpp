// breaks: hits_where_it_is_aimed
// Returns nothing, whatever the ray.
#include "pt/tasks/hit_triangle.h"

namespace pt {

std::optional<SurfaceHit> hit_triangle(const Triangle&, const Ray&) { return {}; }

}  // namespace pt
