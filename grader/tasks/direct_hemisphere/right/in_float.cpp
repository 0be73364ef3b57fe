// right: colors and cosines in single precision, pi to six digits, the constants folded.
#include "pt/geometry/spawn_ray.h"
#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"

namespace pt {

Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  float r = 0, g = 0, b = 0;
  for (int i = 0; i < samples; ++i) {
    const Vec3 wi = uniform_hemisphere(sampler.next_2d());
    const Vec3 direction = point.frame.to_world(wi);
    const Ray ray = spawn_ray(point, direction);
    const std::optional<Hit> hit = scene.closest(ray);
    const Rgb light = hit ? surface_point(scene, ray, *hit).emission : background(scene, direction);
    const Rgb found = diffuse_f(point.albedo, wo, wi) * light;
    const float cosine = static_cast<float>(wi.z);
    r += static_cast<float>(found.r) * cosine;
    g += static_cast<float>(found.g) * cosine;
    b += static_cast<float>(found.b) * cosine;
  }
  const float factor = 2 * 3.14159f / static_cast<float>(samples);
  return {r * factor, g * factor, b * factor};
}

}  // namespace pt
