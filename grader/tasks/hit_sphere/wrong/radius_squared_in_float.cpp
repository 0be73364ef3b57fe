// breaks: misses_beside_the_sphere
// Keeps the squared radius in single precision.
#include "pt/tasks/hit_sphere.h"

#include <cmath>

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  const Vec3 to_center = sphere.center - ray.origin;
  const double a = length_squared(ray.direction), b = dot(to_center, ray.direction);
  const Vec3 beside = to_center - (b / a) * ray.direction;
  const auto radius_squared = static_cast<float>(sphere.radius * sphere.radius);
  const double discriminant = a * (radius_squared - length_squared(beside));
  if (!(discriminant >= 0)) return std::nullopt;
  const double middle = b / a, half = std::sqrt(discriminant) / a;
  for (const double t : {middle - half, middle + half}) {
    if (t >= ray.t_min && t <= ray.t_max) {
      return SurfaceHit{t, normalize(ray.at(t) - sphere.center)};
    }
  }
  return std::nullopt;
}

}  // namespace pt
