#include "grader/stand_ins/counting.h"
#include "pt/tasks/hit_sphere.h"

#include <cmath>

namespace pt {

// The point of the ray next to the centre, and half the chord to either side of it.
std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  grader::count(sphere);
  const double speed = length(ray.direction);
  const Vec3 d = ray.direction / speed;
  const double middle = dot(sphere.center - ray.origin, d);
  const Vec3 foot = ray.origin + middle * d - sphere.center;
  const double half_chord = std::sqrt(sphere.radius * sphere.radius - length_squared(foot));
  for (const double distance : {middle - half_chord, middle + half_chord}) {
    const double t = distance / speed;
    if (t >= ray.t_min && t <= ray.t_max) {
      return SurfaceHit{t, (ray.at(t) - sphere.center) / sphere.radius};
    }
  }
  return std::nullopt;
}

}  // namespace pt
