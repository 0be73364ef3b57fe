#include "pt/tasks/camera_ray.h"

#include <cmath>

namespace pt {

namespace {

// tan(fov / 2), kept from the last call: a tangent takes as long as the rest of the function, and
// all rays of a picture have the same two fields of view.
class HalfTangent {
 public:
  double of(double fov_deg) {
    if (fov_deg != fov_deg_) {
      fov_deg_ = fov_deg;
      tangent_ = std::tan(0.5 * (fov_deg * (kPi / 180)));
    }
    return tangent_;
  }

 private:
  double fov_deg_ = 0;
  double tangent_ = 0;
};

constinit thread_local HalfTangent horizontal, vertical;

}  // namespace

// The same operations as in reference/1_rays/camera_ray.cpp; only the two tangents are kept.
Ray camera_ray(const Camera& camera, double x, double y) {
  const double half_width = horizontal.of(camera.hfov_deg);
  const double half_height = vertical.of(camera.vfov_deg);
  const Vec3 on_window{(2 * x - 1) * half_width, (2 * y - 1) * half_height, -1};
  const Vec3 direction = normalize(camera.camera_to_world.to_world(on_window));
  return {camera.position, direction, camera.near_clip, camera.far_clip};
}

}  // namespace pt
