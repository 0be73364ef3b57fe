#include "pt/tasks/camera_ray.h"

#include <cmath>

namespace pt {

namespace {

double radians(double degrees) { return degrees * (kPi / 180); }

}  // namespace

Ray camera_ray(const Camera& camera, double x, double y) {
  // The window at z = -1 reaches from -tan(fov / 2) to tan(fov / 2) on each axis.
  const double half_width = std::tan(0.5 * radians(camera.hfov_deg));
  const double half_height = std::tan(0.5 * radians(camera.vfov_deg));
  const Vec3 on_window{(2 * x - 1) * half_width, (2 * y - 1) * half_height, -1};

  // The camera's position is only the ray's origin; it is not added to the direction.
  const Vec3 direction = normalize(camera.camera_to_world.to_world(on_window));
  return {camera.position, direction, camera.near_clip, camera.far_clip};
}

}  // namespace pt
