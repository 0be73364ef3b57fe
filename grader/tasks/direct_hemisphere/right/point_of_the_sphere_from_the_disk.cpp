// right: a point of the whole sphere from a point of the disk (Marsaglia 1972), turned up.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"

#include <cmath>

namespace pt {

namespace {

Vec3 turned_up(Sampler& sampler) {
  for (;;) {
    const Vec2 xi = sampler.next_2d();
    const double x = 2 * xi.x - 1, y = 2 * xi.y - 1;
    const double squared = x * x + y * y;
    if (squared >= 1) continue;
    const double root = 2 * std::sqrt(1 - squared);
    return {x * root, y * root, std::abs(1 - 2 * squared)};
  }
}

}  // namespace

Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const Vec3 wi = turned_up(sampler);
    const Vec3 direction = point.frame.to_world(wi);
    const Ray ray = spawn_ray(point, direction);
    const std::optional<Hit> hit = scene.closest(ray);
    const Rgb light = hit ? surface_point(scene, ray, *hit).emission : background(scene, direction);
    sum += diffuse_f(point.albedo, wo, wi) * light * wi.z;
  }
  return sum * (2 * kPi / samples);
}

}  // namespace pt
