// breaks: keeps_the_picture_flat
// Divides the angle evenly instead of the window.
#include "pt/tasks/camera_ray.h"

#include <cmath>

namespace pt {

Ray camera_ray(const Camera& camera, double x, double y) {
  const double yaw = (x - 0.5) * camera.hfov_deg * kPi / 180;
  const double pitch = (y - 0.5) * camera.vfov_deg * kPi / 180;
  const Vec3 local{std::tan(yaw), std::tan(pitch), -1};
  const Vec3 direction = normalize(camera.camera_to_world.to_world(local));
  return {camera.position, direction, camera.near_clip, camera.far_clip};
}

}  // namespace pt
