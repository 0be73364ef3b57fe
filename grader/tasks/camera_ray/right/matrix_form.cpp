// right: a matrix with the window's size in its columns
#include "pt/tasks/camera_ray.h"

#include <cmath>

namespace pt {

Ray camera_ray(const Camera& camera, double x, double y) {
  const Frame& f = camera.camera_to_world;
  const double w = std::tan(camera.hfov_deg * kPi / 360), h = std::tan(camera.vfov_deg * kPi / 360);
  const double m[3][3] = {
      {w * f.x.x, h * f.y.x, f.z.x}, {w * f.x.y, h * f.y.y, f.z.y}, {w * f.x.z, h * f.y.z, f.z.z}};
  const double v[3] = {2 * x - 1, 2 * y - 1, -1};
  Vec3 d;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) d[row] += m[row][column] * v[column];
  }
  return {camera.position, d / length(d), camera.near_clip, camera.far_clip};
}

}  // namespace pt
