// breaks: sees_a_light_of_known_size
// Only triangles glow, spheres do not.
#include "pt/geometry/spawn_ray.h"
#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"

namespace pt {

namespace {

// The radiance that arrives at the point along wi straight from an emitter.
Rgb arriving(const Scene& scene, const SurfacePoint& point, Vec3 wi) {
  const Ray ray = spawn_ray(point, wi);
  const std::optional<Hit> hit = scene.closest(ray);
  if (hit && !scene.primitives.is_triangle(hit->primitive)) return {};
  return hit ? surface_point(scene, ray, *hit).emission : background(scene, wi);
}

}  // namespace

Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  constexpr double kPdf = 1 / (2 * kPi);
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const Vec3 wi = uniform_hemisphere(sampler.next_2d());
    const Rgb light = arriving(scene, point, point.frame.to_world(wi));
    sum += diffuse_f(point.albedo, wo, wi) * light * (wi.z / kPdf);
  }
  return sum / samples;
}

}  // namespace pt
