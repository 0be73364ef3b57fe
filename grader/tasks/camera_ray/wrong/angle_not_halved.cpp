// breaks: fills_the_field_of_view
// Uses the whole angle of view where half of it belongs.
#include "pt/tasks/camera_ray.h"

#include <cmath>

namespace pt {

Ray camera_ray(const Camera& camera, double x, double y) {
  const double half_width = std::tan(camera.hfov_deg * kPi / 180);
  const double half_height = std::tan(camera.vfov_deg * kPi / 180);
  const Vec3 local{(2 * x - 1) * half_width, (2 * y - 1) * half_height, -1};
  const Vec3 direction = normalize(camera.camera_to_world.to_world(local));
  return {camera.position, direction, camera.near_clip, camera.far_clip};
}

}  // namespace pt
