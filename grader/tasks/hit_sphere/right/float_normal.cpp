// right: the normal in single precision, the point in double
#include "pt/tasks/hit_sphere.h"

#include <cmath>

namespace pt {

namespace {

struct Vec3f {
  float x, y, z;
};

Vec3 unit(Vec3f v) {
  const float inverse = 1.0f / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return {v.x * inverse, v.y * inverse, v.z * inverse};
}

}  // namespace

std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  const Vec3 to_center = sphere.center - ray.origin;
  const double speed_squared = dot(ray.direction, ray.direction);
  const double middle = dot(to_center, ray.direction) / speed_squared;
  const Vec3 beside = to_center - middle * ray.direction;
  const double half_squared = (sphere.radius * sphere.radius - dot(beside, beside)) / speed_squared;
  if (!(half_squared >= 0)) return {};

  double t = middle - std::sqrt(half_squared);
  if (t < ray.t_min) t = middle + std::sqrt(half_squared);
  if (t < ray.t_min || t > ray.t_max) return {};
  const Vec3 from_center = (ray.at(t) - sphere.center) / sphere.radius;
  return SurfaceHit{t, unit({static_cast<float>(from_center.x), static_cast<float>(from_center.y),
                             static_cast<float>(from_center.z)})};
}

}  // namespace pt
