// breaks: hits_from_inside
// Requires both roots to lie in the range, which fails inside the sphere.
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
  if (t1 < ray.t_min || t1 > ray.t_max || t2 < ray.t_min || t2 > ray.t_max) return std::nullopt;
  return SurfaceHit{t1, (ray.at(t1) - sphere.center) / sphere.radius};
}

}  // namespace pt
