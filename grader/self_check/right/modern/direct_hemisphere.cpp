#include "pt/tasks/direct_hemisphere.h"

#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>
namespace pt {
Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  Rgb mean;
  const Vec3 wo = point.frame.to_local(point.wo);
  for (int i = 1; i <= samples; ++i) {
    // uniform on the sphere, folded up
    const double z = std::abs(2 * sampler.next_1d() - 1), phi = 2 * kPi * sampler.next_1d();
    const double s = std::sqrt(std::max(0., 1 - z * z));
    const Vec3 wi{s * std::cos(phi), s * std::sin(phi), z};
    const Vec3 w = point.frame.to_world(wi);
    const Ray ray = spawn_ray(point, w);
    const auto hit = scene.closest(ray);
    const Rgb light = hit ? surface_point(scene, ray, *hit).emission : background(scene, w);
    const Rgb value = diffuse_f(point.albedo, wo, wi) * light * z * 2 * kPi;
    mean += (value + -1. * mean) / i;  // running mean
  }
  return mean;
}
}  // namespace pt
