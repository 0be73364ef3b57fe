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
  const double t = t1 > 0 ? t1 : t2;
  return SurfaceHit{t, (ray.at(t) - sphere.center) / sphere.radius};
}

}  // namespace pt
