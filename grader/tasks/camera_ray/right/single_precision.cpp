// right: everything in single precision, with pi to six digits
#include "pt/tasks/camera_ray.h"

#include <cmath>

namespace pt {

namespace {

struct Vec3f {
  float x, y, z;
};

Vec3f single(Vec3 v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

float half_size(double degrees) {
  return std::tan(static_cast<float>(degrees) * 3.14159f / 180.0f * 0.5f);
}

}  // namespace

Ray camera_ray(const Camera& camera, double x, double y) {
  const float a = (2.0f * static_cast<float>(x) - 1.0f) * half_size(camera.hfov_deg);
  const float b = (2.0f * static_cast<float>(y) - 1.0f) * half_size(camera.vfov_deg);
  const Vec3f fx = single(camera.camera_to_world.x), fy = single(camera.camera_to_world.y),
              fz = single(camera.camera_to_world.z);
  const Vec3f d{a * fx.x + b * fy.x - fz.x, a * fx.y + b * fy.y - fz.y, a * fx.z + b * fy.z - fz.z};
  const float scale = 1.0f / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
  const Vec3f p = single(camera.position);
  return {{p.x, p.y, p.z},
          {d.x * scale, d.y * scale, d.z * scale},
          static_cast<float>(camera.near_clip),
          static_cast<float>(camera.far_clip)};
}

}  // namespace pt
