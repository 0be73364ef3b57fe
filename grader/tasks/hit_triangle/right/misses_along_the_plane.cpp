// right: it misses if the angle between the ray and the plane is below a millionth
#include "pt/tasks/hit_triangle.h"

#include <cmath>

namespace pt {

std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  const Vec3 e1 = triangle.p1 - triangle.p0, e2 = triangle.p2 - triangle.p0;
  const Vec3 face = cross(e1, e2);
  const double slope = dot(ray.direction, face);
  if (!(std::abs(slope) > 0.9e-6 * length(ray.direction) * length(face))) return std::nullopt;
  const Vec3 s = ray.origin - triangle.p0;
  const double t = -dot(s, face) / slope;
  if (!(t >= ray.t_min && t <= ray.t_max)) return std::nullopt;
  const Vec3 moment = cross(s, ray.direction);
  const double b1 = dot(e2, moment) / -slope, b2 = dot(e1, moment) / slope;
  if (!(b1 >= 0 && b2 >= 0 && b1 + b2 <= 1)) return std::nullopt;
  const Vec3 n = (1 - b1 - b2) * triangle.n0 + b1 * triangle.n1 + b2 * triangle.n2;
  return SurfaceHit{t, normalize(n)};
}

}  // namespace pt
