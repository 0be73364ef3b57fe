// right: half the width and half the height of the window, times 2x - 1 and 2y - 1
#include "pt/tasks/camera_ray.h"

#include <cmath>

namespace pt {

Ray camera_ray(const Camera& camera, double x, double y) {
  const double half_width = std::tan(camera.hfov_deg * kPi / 360);
  const double half_height = std::tan(camera.vfov_deg * kPi / 360);
  const Vec3 local{(2 * x - 1) * half_width, (2 * y - 1) * half_height, -1};
  const Vec3 direction = normalize(camera.camera_to_world.to_world(local));
  return {camera.position, direction, camera.near_clip, camera.far_clip};
}

}  // namespace pt
