#include "pt/tasks/camera_ray.h"

#include <cmath>
namespace pt {
Ray camera_ray(const Camera& camera, double x, double y) {
  const float pi = 3.14159f;
  float h = camera.hfov_deg * pi / 180.0f, v = camera.vfov_deg * pi / 180.0f;
  Vec3 bottom_left{-tanf(h * .5f), -tanf(v * .5f), -1};
  Vec3 top_right{tanf(h * .5f), tanf(v * .5f), -1};
  Vec3 p{bottom_left.x + (top_right.x - bottom_left.x) * x,
         bottom_left.y + (top_right.y - bottom_left.y) * y, -1};
  Vec3 d = camera.camera_to_world.x * p.x + camera.camera_to_world.y * p.y +
           camera.camera_to_world.z * p.z;
  Ray r;
  r.origin = camera.position;
  r.direction = normalize(d);
  r.t_min = camera.near_clip;
  r.t_max = camera.far_clip;
  return r;
}
}  // namespace pt
