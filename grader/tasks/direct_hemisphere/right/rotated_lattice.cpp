// right: a lattice of directions, moved as a whole by two random numbers (Cranley and Patterson
// 1976).
#include "pt/geometry/spawn_ray.h"
#include "pt/sampling/directions.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"

#include <cmath>

namespace pt {

Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  const Vec2 start = sampler.next_2d();
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const double x = start.x + static_cast<double>(i) / samples;
    const double y = start.y + i * golden;
    const Vec3 wi = uniform_hemisphere({x - std::floor(x), y - std::floor(y)});
    const Vec3 direction = point.frame.to_world(wi);
    const Ray ray = spawn_ray(point, direction);
    const std::optional<Hit> hit = scene.closest(ray);
    const Rgb light = hit ? surface_point(scene, ray, *hit).emission : background(scene, direction);
    sum += diffuse_f(point.albedo, wo, wi) * light * wi.z;
  }
  return sum * (2 * kPi / samples);
}

}  // namespace pt
