#include "pt/tasks/direct_lights.h"

namespace pt {

Rgb direct_lights(const Scene&, const SurfacePoint& point, int, Sampler&) { return point.albedo; }

}  // namespace pt
