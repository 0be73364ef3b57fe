#include "pt/tasks/hit_sphere.h"

#include <cmath>
#include <utility>

namespace pt {

// |origin + t d - center|^2 = radius^2 is the quadratic a t^2 - 2 b t + c = 0 in t. The textbook's
// discriminant b^2 - a c is a small difference of two large numbers when the sphere is far away, and
// loses its digits. Haines et al. 2019 (Ray Tracing Gems, chapter 7) use the distance from the
// centre to the ray instead: for a hit it is at most the radius, however far away the sphere is.
std::optional<SurfaceHit> hit_sphere(const Sphere& sphere, const Ray& ray) {
  const Vec3 d = ray.direction;
  const Vec3 to_center = sphere.center - ray.origin;
  const double radius_squared = sphere.radius * sphere.radius;
  const double a = length_squared(d);
  const double b = dot(to_center, d);
  const double c = length_squared(to_center) - radius_squared;

  const Vec3 ray_to_center = to_center - (b / a) * d;
  const double discriminant = a * (radius_squared - length_squared(ray_to_center));
  if (!(discriminant >= 0)) return std::nullopt;

  // Either b - root or b + root may lose its digits. q is the one that keeps them: it gives one t
  // as q / a, and the other t follows from t1 t2 = c / a.
  const double q = b + std::copysign(std::sqrt(discriminant), b);
  double t_near = c / q;
  double t_far = q / a;
  if (t_near > t_far) std::swap(t_near, t_far);

  for (const double t : {t_near, t_far}) {
    if (t >= ray.t_min && t <= ray.t_max) {
      return SurfaceHit{t, normalize(ray.at(t) - sphere.center)};
    }
  }
  return std::nullopt;
}

}  // namespace pt
