// right: three normally distributed numbers, normalised; Marsaglia and Bray (1964) make two at a time, by
// rejection, and the fourth is for the next direction.
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_hemisphere.h"

#include <cmath>
#include <optional>

namespace pt {

namespace {

class Normal {
 public:
  explicit Normal(Sampler& sampler) : sampler_(sampler) {}

  double next() {
    if (kept_) {
      const double last = *kept_;
      kept_.reset();
      return last;
    }
    for (;;) {
      const double x = 2 * sampler_.next_1d() - 1, y = 2 * sampler_.next_1d() - 1;
      const double squared = x * x + y * y;
      if (!(squared > 0 && squared < 1)) continue;
      const double factor = std::sqrt(-2 * std::log(squared) / squared);
      kept_ = factor * y;
      return factor * x;
    }
  }

 private:
  Sampler& sampler_;
  std::optional<double> kept_;
};

Vec3 direction_above(Normal& normal) {
  const double x = normal.next(), y = normal.next(), z = std::abs(normal.next());
  return normalize(Vec3{x, y, z});
}

}  // namespace

Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Normal normal(sampler);
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const Vec3 wi = direction_above(normal);
    const Vec3 direction = point.frame.to_world(wi);
    const Ray ray = spawn_ray(point, direction);
    const std::optional<Hit> hit = scene.closest(ray);
    const Rgb light = hit ? surface_point(scene, ray, *hit).emission : background(scene, direction);
    sum += diffuse_f(point.albedo, wo, wi) * light * wi.z;
  }
  return sum * (2 * kPi / samples);
}

}  // namespace pt
