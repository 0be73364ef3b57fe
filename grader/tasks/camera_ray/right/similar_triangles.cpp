// right: a local class for an axis, std::function, and pi to six digits
#include "pt/tasks/camera_ray.h"

#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace pt {

Ray camera_ray(const Camera& camera, double x, double y) {
  constexpr double kDegree = 3.14159 / 180;
  class Axis {
   public:
    explicit Axis(double degrees) : edge_(std::sin(degrees / 2) / std::cos(degrees / 2)) {}
    double at(double part) const { return part * edge_ + (1 - part) * -edge_; }

   private:
    double edge_;
  };
  const std::function<double(double, double)> on_window = [](double fov_deg, double part) {
    return Axis(fov_deg * kDegree).at(part);
  };
  std::array<double, 3> local{on_window(camera.hfov_deg, x), on_window(camera.vfov_deg, y), -1};
  const double size = std::sqrt(std::inner_product(local.begin(), local.end(), local.begin(), 0.0));
  for (double& component : local) component /= size;

  Ray ray;
  ray.direction = camera.camera_to_world.to_world({local[0], local[1], local[2]});
  ray.origin = camera.position;
  ray.t_max = camera.far_clip;
  ray.t_min = camera.near_clip;
  return ray;
}

}  // namespace pt
