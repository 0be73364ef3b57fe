#pragma once

#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

#include <array>
#include <cstdint>
#include <span>

namespace pt {

// Draws of one light, each of which brings light unless its shadow ray is blocked.
struct LightDraws {
  std::array<Ray, 8> shadow_rays;
  std::array<Rgb, 8> light;
  std::size_t count = 0;

  bool is_full() const { return count == light.size(); }

  void add(const Ray& shadow_ray, const Rgb& light_along_it) {
    shadow_rays[count] = shadow_ray;
    light[count] = light_along_it;
    ++count;
  }
};

// The task direct_lights, but that shadow rays are traced in groups of up to eight. `occluded` takes
// a span of rays and returns a mask: bit i says whether ray i is blocked.
//
// Random numbers are drawn and light is added in the order of the plain loop in reference/, so the
// result has the same bits.
template <typename Occluded>
Rgb direct_lights_grouped(const Scene& scene, const SurfacePoint& point, int samples,
                          Sampler& sampler, const Occluded& occluded) {
  const Vec3 wo = point.frame.to_local(point.wo);
  LightDraws group;
  Rgb sum;
  for (const Light& light : scene.lights) {
    const int draws = is_delta(light) ? 1 : samples;
    Rgb of_this_light;
    for (int i = 0; i < draws; ++i) {
      const LightSample sample = sample_light(light, point.p, sampler);
      const Vec3 wi = point.frame.to_local(sample.wi);
      if (wi.z > 0 && !is_black(sample.radiance)) {
        const Rgb f = diffuse_f(point.albedo, wo, wi);
        group.add(shadow_ray(point, sample.wi, sample.distance),
                  f * sample.radiance * (wi.z / sample.pdf));
      }
      if (!group.is_full() && i + 1 < draws) continue;

      const std::uint32_t blocked = occluded(std::span(group.shadow_rays.data(), group.count));
      for (std::size_t k = 0; k < group.count; ++k) {
        if ((blocked >> k & 1) == 0) of_this_light += group.light[k];
      }
      group.count = 0;
    }
    sum += of_this_light / draws;
  }
  return sum;
}

}  // namespace pt
