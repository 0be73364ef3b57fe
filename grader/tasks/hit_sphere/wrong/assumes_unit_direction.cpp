#include "pt/tasks/hit_sphere.h"

#include <cmath>
#include <utility>

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  const Vec3 oc = ray.origin - sphere.center;
  const double b = dot(oc, ray.direction);
  const double c = dot(oc, oc) - sphere.radius * sphere.radius;
  const double discriminant = b * b - c;
  if (!(discriminant >= 0)) return std::nullopt;
  const double root = std::sqrt(discriminant);
  for (const double t : {-b - root, -b + root}) {
    if (t >= ray.t_min && t <= ray.t_max) {
      return SurfaceHit{t, (ray.at(t) - sphere.center) / sphere.radius};
    }
  }
  return std::nullopt;
}

}  // namespace pt
