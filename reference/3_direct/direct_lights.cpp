#include "pt/tasks/direct_lights.h"

#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"

#include <algorithm>
#include <array>
#include <span>

namespace pt {

namespace {

// Draws of one light that bring something if nothing is in the way. Their shadow rays are what
// costs time, and cost less when the scene is asked about all of them at once.
struct Draws {
  std::array<Ray, 8> rays;
  std::array<Rgb, 8> light;
  std::size_t count = 0;
};

Draws draw(const SurfacePoint& point, const Light& light, int samples, Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Draws draws;
  for (int i = 0; i < samples; ++i) {
    const LightSample sample = sample_light(light, point.p, sampler);
    const Vec3 wi = point.frame.to_local(sample.wi);
    if (!(wi.z > 0) || is_black(sample.radiance)) continue;
    draws.rays[draws.count] = shadow_ray(point, sample.wi, sample.distance);
    draws.light[draws.count] =
        diffuse_f(point.albedo, wo, wi) * sample.radiance * (wi.z / sample.pdf);
    ++draws.count;
  }
  return draws;
}

Rgb what_arrives(const Scene& scene, const Draws& draws) {
  const std::uint32_t blocked = scene.occluded(std::span(draws.rays.data(), draws.count));
  Rgb sum;
  for (std::size_t i = 0; i < draws.count; ++i) {
    if ((blocked >> i & 1) == 0) sum += draws.light[i];
  }
  return sum;
}

}  // namespace

Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  Rgb sum;
  for (const Light& light : scene.lights) {
    // All draws of a delta light are the same one.
    const int draws = is_delta(light) ? 1 : samples;
    Rgb of_this_light;
    for (int done = 0; done < draws; done += 8) {
      const int more = std::min(8, draws - done);
      of_this_light += what_arrives(scene, draw(point, light, more, sampler));
    }
    sum += of_this_light / draws;
  }
  return sum;
}

}  // namespace pt
