#include "pt/tasks/direct_hemisphere.h"

#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <cmath>
namespace pt {
Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  Rgb sum;
  Vec3 wo = point.frame.to_local(point.wo);
  for (int i = 0; i < samples; i++) {
    double xi1 = sampler.next_1d(), xi2 = sampler.next_1d();
    double theta = std::acos(xi1), phi = 2.0 * M_PI * xi2;
    Vec3 wi{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
    Vec3 world = normalize(point.frame.to_world(wi));
    Ray ray = spawn_ray(point, world);
    Rgb L;
    if (auto hit = scene.closest(ray))
      L = surface_point(scene, ray, *hit).emission;
    else
      L = background(scene, world);
    float cosine = (float)wi.z;
    sum += diffuse_f(point.albedo, wo, wi) * L * cosine * (2.0 * 3.14159265);
  }
  return sum * (1.0 / samples);
}
}  // namespace pt
