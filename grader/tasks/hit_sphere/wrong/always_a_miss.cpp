#include "pt/tasks/hit_sphere.h"

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere&, const Ray&) { return {}; }

}  // namespace pt
