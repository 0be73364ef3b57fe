// breaks: fills_the_field_of_view
// Takes pi as 3.1416, which is too coarse for wide windows.
#include "pt/tasks/camera_ray.h"

#include <algorithm>
#include <cmath>
namespace pt {
Ray camera_ray(const Camera& camera, double x, double y) {
  const double w = std::tan(camera.hfov_deg * 3.1416 / 360),
               h = std::tan(camera.vfov_deg * 3.1416 / 360);
  const Vec3 local = normalize({(2 * x - 1) * w, (2 * y - 1) * h, -1});
  return {camera.position, camera.camera_to_world.to_world(local), camera.near_clip,
          camera.far_clip};
}
}  // namespace pt
