// right: x - 1/2 of the window's whole width
#include "pt/tasks/camera_ray.h"

#include <cmath>

namespace pt {

Ray camera_ray(const Camera& camera, double x, double y) {
  const double width = 2 * std::tan(0.5 * (camera.hfov_deg / 180 * kPi));
  const double height = 2 * std::tan(0.5 * (camera.vfov_deg / 180 * kPi));
  const Vec3 local = normalize({(x - 0.5) * width, (y - 0.5) * height, -1});
  Ray ray;
  ray.origin = camera.position;
  ray.direction = camera.camera_to_world.to_world(local);
  ray.t_min = camera.near_clip;
  ray.t_max = camera.far_clip;
  return ray;
}

}  // namespace pt
