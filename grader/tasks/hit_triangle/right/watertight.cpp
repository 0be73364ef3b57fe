// right: Woop, Benthin and Wald 2013: the triangle sheared into the ray's own frame
#include "pt/tasks/hit_triangle.h"

#include <cmath>
#include <utility>

namespace pt {

std::optional<SurfaceHit> hit_triangle(const Triangle& triangle, const Ray& ray) {
  const Vec3 d = ray.direction;
  int z = 0;
  for (const int axis : {1, 2}) {
    if (std::abs(d[axis]) > std::abs(d[z])) z = axis;
  }
  const int x = (z + 1) % 3, y = (z + 2) % 3;
  const double shear_x = d[x] / d[z], shear_y = d[y] / d[z];

  const Vec3 a = triangle.p0 - ray.origin;
  const Vec3 b = triangle.p1 - ray.origin;
  const Vec3 c = triangle.p2 - ray.origin;
  const double ax = a[x] - shear_x * a[z], ay = a[y] - shear_y * a[z];
  const double bx = b[x] - shear_x * b[z], by = b[y] - shear_y * b[z];
  const double cx = c[x] - shear_x * c[z], cy = c[y] - shear_y * c[z];

  const double u = cx * by - cy * bx;
  const double v = ax * cy - ay * cx;
  const double w = bx * ay - by * ax;
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
  const double sum = u + v + w;
  if (sum == 0) return std::nullopt;

  const double t = (u * a[z] + v * b[z] + w * c[z]) / (sum * d[z]);
  if (!(t >= ray.t_min && t <= ray.t_max)) return std::nullopt;
  return SurfaceHit{t, normalize((u * triangle.n0 + v * triangle.n1 + w * triangle.n2) / sum)};
}

}  // namespace pt
