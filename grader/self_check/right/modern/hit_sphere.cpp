#include "pt/tasks/hit_sphere.h"

#include <cmath>
namespace pt {
// geometric: foot of the perpendicular from the centre, then Pythagoras
std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  double len = length(ray.direction);
  Vec3 d = ray.direction / len;
  Vec3 oc = sphere.center - ray.origin;
  double tca = dot(oc, d);
  Vec3 foot = ray.origin + tca * d;
  double d2 = length_squared(foot - sphere.center), r2 = sphere.radius * sphere.radius;
  if (d2 > r2) return std::nullopt;
  double thc = std::sqrt(r2 - d2);
  for (double s : {tca - thc, tca + thc}) {
    double t = s / len;
    if (t >= ray.t_min && t <= ray.t_max)
      return SurfaceHit{t, (ray.at(t) - sphere.center) / sphere.radius};
  }
  return std::nullopt;
}
}  // namespace pt
