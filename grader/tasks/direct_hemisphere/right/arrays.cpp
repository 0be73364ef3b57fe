// right: all that the directions bring is kept in an array, and a sampler of its own is seeded by
// a number that it draws from the one given.
#include "pt/geometry/spawn_ray.h"
#include "pt/sampling/directions.h"
#include "pt/tasks/direct_hemisphere.h"

#include <functional>
#include <valarray>

namespace pt {

Rgb direct_hemisphere(const Scene& scene, const SurfacePoint& point, int samples,
                      Sampler& sampler) {
  Sampler own(static_cast<std::uint64_t>(sampler.next_1d() * 0x1p53));
  const std::function<Rgb(Vec3)> arriving = [&](Vec3 direction) {
    const Ray ray = spawn_ray(point, direction);
    const std::optional<Hit> hit = scene.closest(ray);
    return hit ? surface_point(scene, ray, *hit).emission : background(scene, direction);
  };
  const auto n = static_cast<std::size_t>(samples);
  std::valarray<double> r(n), g(n), b(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 wi = uniform_hemisphere(own.next_2d());
    const Rgb found = 2 * wi.z * point.albedo * arriving(point.frame.to_world(wi));
    r[i] = found.r;
    g[i] = found.g;
    b[i] = found.b;
  }
  return Rgb{r.sum(), g.sum(), b.sum()} / samples;
}

}  // namespace pt
