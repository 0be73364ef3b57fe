// right: the point of the line beside the centre, and half the chord on each side of it
#include "pt/tasks/hit_sphere.h"

#include <cmath>

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  const Vec3 to_center = sphere.center - ray.origin;
  const double a = length_squared(ray.direction), b = dot(to_center, ray.direction);
  const Vec3 beside = to_center - (b / a) * ray.direction;
  const double discriminant = a * (sphere.radius * sphere.radius - length_squared(beside));
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
