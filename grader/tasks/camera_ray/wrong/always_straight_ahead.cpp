#include "pt/tasks/camera_ray.h"

#include <algorithm>
#include <cmath>

namespace pt {

Ray camera_ray(const Camera& camera, double x, double y) {
  (void)x;
  (void)y;
  return {camera.position, -camera.camera_to_world.z, camera.near_clip, camera.far_clip};
}

}  // namespace pt
