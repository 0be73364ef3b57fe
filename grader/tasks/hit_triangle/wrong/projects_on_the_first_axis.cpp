#include "pt/tasks/hit_triangle.h"

#include <cmath>
#include <utility>

namespace pt {

std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  const Vec3 n = cross(triangle.p1 - triangle.p0, triangle.p2 - triangle.p0);
  const double t = dot(triangle.p0 - ray.origin, n) / dot(ray.direction, n);
  if (!(t >= ray.t_min && t <= ray.t_max)) return std::nullopt;
  const Vec3 p = ray.at(t);
  const int drop = n.x != 0 ? 0 : n.y != 0 ? 1 : 2;
  const int u = (drop + 1) % 3, v = (drop + 2) % 3;
  const auto area = [&](Vec3 a, Vec3 b, Vec3 c) {
    return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
  };
  const double b0 = area(p, triangle.p1, triangle.p2) / n[drop];
  const double b1 = area(p, triangle.p2, triangle.p0) / n[drop];
  const double b2 = 1 - b0 - b1;
  if (!(b0 >= 0 && b1 >= 0 && b2 >= 0)) return std::nullopt;
  return SurfaceHit{t, normalize(b0 * triangle.n0 + b1 * triangle.n1 + b2 * triangle.n2)};
}

}  // namespace pt
