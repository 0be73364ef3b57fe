#include "pt/tasks/hit_sphere.h"

#include <cmath>
#include <utility>

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  const Vec3 oc = ray.origin - sphere.center;
  const float a = static_cast<float>(dot(ray.direction, ray.direction));
  const float half_b = static_cast<float>(dot(oc, ray.direction));
  const float c = static_cast<float>(dot(oc, oc) - sphere.radius * sphere.radius);
  const float discriminant = half_b * half_b - a * c;
  if (discriminant < 0) return std::nullopt;
  const float root = std::sqrt(discriminant);
  for (const float t : {(-half_b - root) / a, (-half_b + root) / a}) {
    if (t >= ray.t_min && t <= ray.t_max) {
      return SurfaceHit{t, normalize(ray.at(t) - sphere.center)};
    }
  }
  return std::nullopt;
}

}  // namespace pt
