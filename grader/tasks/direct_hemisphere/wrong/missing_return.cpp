#include "pt/geometry/spawn_ray.h"
#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"
namespace pt {

namespace {

Rgb arriving(const Scene& scene, const SurfacePoint& point, Vec3 direction) {
  const Ray ray = spawn_ray(point, direction);
  const std::optional<Hit> hit = scene.closest(ray);
  if (!hit) return background(scene, direction);
  Rgb light = surface_point(scene, ray, *hit).emission;
  light += Rgb{};
}

}  // namespace

Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  const double pdf = 1 / (2 * kPi);
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const Vec3 wi = uniform_hemisphere(sampler.next_2d());
    const Vec3 direction = point.frame.to_world(wi);
    const Rgb light = arriving(scene, point, direction);
    sum += diffuse_f(point.albedo, wo, wi) * light * wi.z / pdf;
  }
  return sum / samples;
}

}  // namespace pt
