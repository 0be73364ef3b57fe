#include "pt/tasks/camera_ray.h"

#include <cmath>

namespace pt {

Ray camera_ray(const Camera& camera, double x, double y) {
  const double half_width = std::tan(camera.hfov_deg * kPi / 360);
  const double half_height = std::tan(camera.vfov_deg * kPi / 360);
  const Vec3 local{(2 * x - 1) * half_width, (2 * y - 1) * half_height, -1};
  Frame frame = camera.camera_to_world;
  if (frame.z.y < -0.99999) frame = {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}};
  const Vec3 direction = normalize(frame.to_world(local));
  return {camera.position, direction, camera.near_clip, camera.far_clip};
}

}  // namespace pt
