// right: geometry instead of algebra: the foot of the perpendicular, and half the chord
#include "pt/tasks/hit_sphere.h"

#include <cmath>
#include <utility>

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  const double speed = length(ray.direction);
  const Vec3 d = ray.direction / speed;
  const double middle = dot(sphere.center - ray.origin, d);
  const double beside = length(ray.origin + middle * d - sphere.center);
  if (beside > sphere.radius) return std::nullopt;
  const double half = std::sqrt((sphere.radius - beside) * (sphere.radius + beside));
  for (const double distance : {middle - half, middle + half}) {
    const double t = distance / speed;
    if (t >= ray.t_min && t <= ray.t_max) {
      return SurfaceHit{t, normalize(ray.at(t) - sphere.center)};
    }
  }
  return std::nullopt;
}

}  // namespace pt
