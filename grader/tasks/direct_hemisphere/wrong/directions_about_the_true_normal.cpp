#include "pt/geometry/spawn_ray.h"
#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"

namespace pt {

namespace {

// The frame of the true surface, on wo's side.
Frame true_frame(const SurfacePoint& point) {
  const Vec3 n = point.geometric_normal;
  return frame_from_normal(dot(n, point.wo) < 0 ? -n : n);
}

// The radiance that arrives at the point along wi straight from an emitter.
Rgb arriving(const Scene& scene, const SurfacePoint& point, Vec3 wi) {
  const Ray ray = spawn_ray(point, wi);
  const std::optional<Hit> hit = scene.closest(ray);
  return hit ? surface_point(scene, ray, *hit).emission : background(scene, wi);
}

}  // namespace

Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  constexpr double kPdf = 1 / (2 * kPi);
  const Frame frame = true_frame(point);
  const Vec3 wo = frame.to_local(point.wo);
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const Vec3 wi = uniform_hemisphere(sampler.next_2d());
    const Rgb light = arriving(scene, point, frame.to_world(wi));
    sum += diffuse_f(point.albedo, wo, wi) * light * (wi.z / kPdf);
  }
  return sum / samples;
}

}  // namespace pt
