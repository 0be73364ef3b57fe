// right: exactly at an end of the range it misses, and where the ray touches the sphere it hits
#include "pt/tasks/hit_sphere.h"

#include <cmath>

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  const Vec3 to_center = sphere.center - ray.origin;
  const double a = dot(ray.direction, ray.direction);
  const double middle = dot(to_center, ray.direction) / a;
  const Vec3 beside = to_center - middle * ray.direction;
  const double squared = sphere.radius * sphere.radius - dot(beside, beside);
  if (!(squared >= 0)) return std::nullopt;
  const double half = std::sqrt(squared / a);
  double t = middle - half;
  if (!(t > ray.t_min)) t = middle + half;
  if (!(t > ray.t_min && t < ray.t_max)) return std::nullopt;
  return SurfaceHit{t, normalize(ray.at(t) - sphere.center)};
}

}  // namespace pt
