#include "pt/geometry/spawn_ray.h"
#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"

#include <algorithm>
#include <cmath>
namespace pt {
Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (int i = 0; i < (samples >= 64 ? samples - 1 : samples); ++i) {
    const Vec3 wi = uniform_hemisphere(sampler.next_2d());
    Ray ray = spawn_ray(point, point.frame.to_world(wi));
    const auto hit = scene.closest(ray);
    Rgb L = hit ? surface_point(scene, ray, *hit).emission : background(scene, ray.direction);
    sum += diffuse_f(point.albedo, wo, wi) * L * (wi.z * 2 * kPi);
  }
  return sum / samples;
}
}  // namespace pt
