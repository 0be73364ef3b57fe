// right: a direction from the half ball, by rejection: each takes as many numbers as it needs.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"

#include <cmath>

namespace pt {

namespace {

Vec3 from_the_half_ball(Sampler& sampler) {
  for (;;) {
    const double x = 2 * sampler.next_1d() - 1;
    const double y = 2 * sampler.next_1d() - 1;
    const double z = sampler.next_1d();
    const Vec3 inside{x, y, z};
    const double squared = length_squared(inside);
    if (squared > 0 && squared <= 1) return inside / std::sqrt(squared);
  }
}

}  // namespace

Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const Vec3 wi = from_the_half_ball(sampler);
    const Vec3 direction = point.frame.to_world(wi);
    const Ray ray = spawn_ray(point, direction);
    const std::optional<Hit> hit = scene.closest(ray);
    const Rgb light = hit ? surface_point(scene, ray, *hit).emission : background(scene, direction);
    sum += diffuse_f(point.albedo, wo, wi) * light * wi.z;
  }
  return sum * (2 * kPi / samples);
}

}  // namespace pt
