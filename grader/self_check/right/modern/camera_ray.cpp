#include "pt/tasks/camera_ray.h"

#include <numbers>
namespace pt {
Ray camera_ray(const Camera& camera, double x, double y) {
  auto tangent = [](double degrees) { return std::tan(degrees / 360 * std::numbers::pi); };
  const auto& [right, up, back] = camera.camera_to_world;
  Vec3 to = std::lerp(-1., 1., x) * tangent(camera.hfov_deg) * right +
            std::lerp(-1., 1., y) * tangent(camera.vfov_deg) * up - back;
  return {.origin = camera.position,
          .direction = to / std::hypot(to.x, to.y, to.z),
          .t_min = camera.near_clip,
          .t_max = camera.far_clip};
}
}  // namespace pt
