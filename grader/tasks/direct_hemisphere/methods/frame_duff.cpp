// method: a frame around the normal as Duff et al. 2017 have it (Building an Orthonormal Basis,
// Revisited, JCGT 6(1))
#include "pt/geometry/spawn_ray.h"
#include "pt/sampling/directions.h"
#include "pt/tasks/direct_hemisphere.h"

#include <cmath>

#ifndef REAL
#define REAL double
#endif

namespace pt {

namespace {

struct V {
  REAL x, y, z;
};

V to_v(Vec3 v) { return {static_cast<REAL>(v.x), static_cast<REAL>(v.y), static_cast<REAL>(v.z)}; }

struct Axes {
  V x, y, z;
};

Axes around(V n) {
  const REAL sign = std::copysign(REAL{1}, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

Vec3 to_world(const Axes& f, V v) {
  return {v.x * f.x.x + v.y * f.y.x + v.z * f.z.x, v.x * f.x.y + v.y * f.y.y + v.z * f.z.y,
          v.x * f.x.z + v.y * f.y.z + v.z * f.z.z};
}

}  // namespace

Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  const Axes axes = around(to_v(point.n));
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const Vec3 wi = uniform_hemisphere(sampler.next_2d());
    const Vec3 direction = to_world(axes, to_v(wi));
    const Ray ray = spawn_ray(point, direction);
    const std::optional<Hit> hit = scene.closest(ray);
    sum += (hit ? surface_point(scene, ray, *hit).emission : background(scene, direction)) * wi.z;
  }
  return 2 * point.albedo * sum / samples;
}

}  // namespace pt
