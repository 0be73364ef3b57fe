// right: between the corners of the window in world space
#include "pt/tasks/camera_ray.h"

#include <cmath>

namespace pt {

Ray camera_ray(const Camera& camera, double x, double y) {
  const Frame& frame = camera.camera_to_world;
  const Vec3 right = std::tan(camera.hfov_deg * kPi / 360) * frame.x;
  const Vec3 up = std::tan(camera.vfov_deg * kPi / 360) * frame.y;
  const Vec3 bottom_left = -frame.z - right - up;
  const Vec3 bottom_right = -frame.z + right - up;
  const Vec3 top_left = -frame.z - right + up;
  const Vec3 d = bottom_left + x * (bottom_right - bottom_left) + y * (top_left - bottom_left);
  return {camera.position, normalize(d), camera.near_clip, camera.far_clip};
}

}  // namespace pt
