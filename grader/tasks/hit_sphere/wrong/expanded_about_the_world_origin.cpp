// breaks: hits_where_it_is_aimed
// Expands the distance to the centre in dot products of positions, which cancel far from the origin of the world.
#include "pt/tasks/hit_sphere.h"

#include <cmath>

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  const Vec3 to_center = sphere.center - ray.origin;
  const double a = length_squared(ray.direction), b = dot(to_center, ray.direction);
  const double c = length_squared(ray.origin) - 2 * dot(ray.origin, sphere.center) +
                   length_squared(sphere.center) - sphere.radius * sphere.radius;
  const double discriminant = b * b - a * c;
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
