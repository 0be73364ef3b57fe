// right: the angle from a point of the disk, found by rejection, and then one number as the height.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"

#include <cmath>

namespace pt {

namespace {

Vec3 height_and_angle(Sampler& sampler) {
  double x = 0, y = 0, squared = 0;
  do {
    x = 2 * sampler.next_1d() - 1;
    y = 2 * sampler.next_1d() - 1;
    squared = x * x + y * y;
  } while (!(squared > 0 && squared < 1));
  const double z = sampler.next_1d();
  const double r = std::sqrt((1 - z * z) / squared);
  return {r * x, r * y, z};
}

}  // namespace

Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const Vec3 wi = height_and_angle(sampler);
    const Vec3 direction = point.frame.to_world(wi);
    const Ray ray = spawn_ray(point, direction);
    const std::optional<Hit> hit = scene.closest(ray);
    const Rgb light = hit ? surface_point(scene, ray, *hit).emission : background(scene, direction);
    sum += diffuse_f(point.albedo, wo, wi) * light * wi.z;
  }
  return sum * (2 * kPi / samples);
}

}  // namespace pt
