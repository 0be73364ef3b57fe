// right: the quadratic with half its linear coefficient
#include "pt/tasks/hit_sphere.h"

#include <cmath>
#include <utility>

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  const Vec3 oc = ray.origin - sphere.center;
  const double a = length_squared(ray.direction);
  const double half_b = dot(oc, ray.direction);
  const double c = length_squared(oc) - sphere.radius * sphere.radius;
  const double discriminant = half_b * half_b - a * c;
  if (!(discriminant > 0)) return std::nullopt;  // a tangent misses
  const double root = std::sqrt(discriminant);
  double t = (-half_b - root) / a;
  if (!(t >= ray.t_min && t <= ray.t_max)) t = (-half_b + root) / a;
  if (!(t >= ray.t_min && t <= ray.t_max)) return std::nullopt;
  return SurfaceHit{t, (ray.at(t) - sphere.center) / sphere.radius};
}

}  // namespace pt
