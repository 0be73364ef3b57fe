// Says that it is surprised.
#include "pt/tasks/camera_ray.h"

#undef NDEBUG
#include <cassert>

namespace pt {

Ray camera_ray(const Camera& camera, double x, double) {
  assert(x < -1);
  return {camera.position, {}};
}

}  // namespace pt
