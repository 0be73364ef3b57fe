// breaks: returns_the_outward_unit_normal
// The normal points to the centre.
#include "pt/tasks/hit_sphere.h"

#include <cmath>
#include <utility>

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  const Vec3 oc = ray.origin - sphere.center;
  const double a = dot(ray.direction, ray.direction);
  const double b = 2 * dot(oc, ray.direction);
  const double c = dot(oc, oc) - sphere.radius * sphere.radius;
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return std::nullopt;
  const double t1 = (-b - std::sqrt(discriminant)) / (2 * a);
  const double t2 = (-b + std::sqrt(discriminant)) / (2 * a);
  for (const double t : {t1, t2}) {
    if (t >= ray.t_min && t <= ray.t_max) {
      return SurfaceHit{t, normalize(sphere.center - ray.at(t))};
    }
  }
  return std::nullopt;
}

}  // namespace pt
