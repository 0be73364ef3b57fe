// breaks: hits_where_it_is_aimed
// Takes a discriminant that is small beside the square of the distance for a rounding error, and misses.
#include "pt/tasks/hit_sphere.h"

#include <cmath>

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  const Vec3 to_center = sphere.center - ray.origin;
  const double a = length_squared(ray.direction), b = dot(to_center, ray.direction);
  const Vec3 beside = to_center - (b / a) * ray.direction;
  const double discriminant = a * (sphere.radius * sphere.radius - length_squared(beside));
  if (!(discriminant >= 0)) return std::nullopt;
  if (discriminant < 4e-12 * b * b) return std::nullopt;
  const double root = std::sqrt(discriminant);
  for (const double t : {(b - root) / a, (b + root) / a}) {
    if (t >= ray.t_min && t <= ray.t_max) {
      return SurfaceHit{t, normalize(ray.at(t) - sphere.center)};
    }
  }
  return std::nullopt;
}

}  // namespace pt
