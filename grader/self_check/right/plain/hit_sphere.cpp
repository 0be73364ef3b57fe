#include "pt/tasks/hit_sphere.h"

#include <cmath>
namespace pt {
std::optional<SurfaceHit> hit_sphere(const Sphere& s, const Ray& r) {
  Vec3 o = r.origin - s.center;
  double a = dot(r.direction, r.direction);
  double b = 2 * dot(o, r.direction);
  double c = dot(o, o) - s.radius * s.radius;
  double disc = b * b - 4 * a * c;
  if (disc < 0) return std::nullopt;
  double t1 = (-b - sqrt(disc)) / (2 * a), t2 = (-b + sqrt(disc)) / (2 * a);
  double t;
  if (t1 >= r.t_min && t1 <= r.t_max)
    t = t1;
  else if (t2 >= r.t_min && t2 <= r.t_max)
    t = t2;
  else
    return std::nullopt;
  return SurfaceHit{t, normalize(r.at(t) - s.center)};
}
}  // namespace pt
