#include "pt/tasks/hit_triangle.h"
namespace pt {
// plane first, then three edge tests (Ericson, Real-Time Collision Detection; Shirley)
std::optional<SurfaceHit> hit_triangle(const Triangle& tri, const Ray& ray) {
  Vec3 e1 = tri.p1 - tri.p0, e2 = tri.p2 - tri.p0;
  Vec3 n = cross(e1, e2);
  double nd = dot(n, ray.direction);
  if (nd == 0) return {};
  double t = dot(n, tri.p0 - ray.origin) / nd;
  if (!(t >= ray.t_min) || !(t <= ray.t_max)) return {};
  Vec3 p = ray.origin + ray.direction * t;
  double nn = dot(n, n);
  if (nn == 0) return {};
  double a = dot(n, cross(tri.p2 - tri.p1, p - tri.p1)) / nn;
  double b = dot(n, cross(tri.p0 - tri.p2, p - tri.p2)) / nn;
  double c = 1 - a - b;
  if (!(a >= 0 && b >= 0 && c >= 0)) return {};
  SurfaceHit hit;
  hit.t = t;
  hit.n = normalize(a * tri.n0 + b * tri.n1 + c * tri.n2);
  return hit;
}
}  // namespace pt
