#pragma once

#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace pt {

// Draws of lights, each of which brings light unless its shadow ray is blocked.
struct LightDraws {
  // Not initialised: that would take as long as tracing a ray.
  union {
    std::array<Ray, 8> shadow_rays;
  };
  union {
    std::array<Rgb, 8> light;
  };
  std::size_t count = 0;

  LightDraws() {}
  bool is_full() const { return count == light.size(); }

  void add(const Ray& shadow_ray, const Rgb& light_along_it) {
    shadow_rays[count] = shadow_ray;
    light[count] = light_along_it;
    ++count;
  }
};

// The task direct_lights, but with lights sampled and shadow rays traced in groups of up to eight.
// `occluded` takes a span of rays and returns a mask: bit i says whether ray i is blocked.
//
// Random numbers are drawn and light is added in the order of the plain loop in reference/, so the
// result has the same bits.
template <typename Occluded>
Rgb direct_lights_grouped(const Scene& scene, const SurfacePoint& point, int samples,
                          Sampler& sampler, const Occluded& occluded) {
  const Vec3 wo = point.frame.to_local(point.wo);
  const Rgb albedo = point.albedo;
  LightDraws group;
  LightSampleGroup drawn;
  Rgb sum;
  for (const Light& light : scene.lights) {
    const int draws = is_delta(light) ? 1 : samples;
    Rgb of_this_light;
    for (int i = 0; i < draws; ++i) {
      const int k = i % kLightGroup;
      if (k == 0) {
        sample_light_group(light, point.p, std::min(draws - i, kLightGroup), sampler, drawn);
      }
      const Vec3 world_wi = drawn.wi_of(k), wi = point.frame.to_local(world_wi);
      if (wi.z > 0 && drawn.is_lit[k]) {
        const Rgb f = diffuse_f(albedo, wo, wi);
        group.add(shadow_ray(point, world_wi, drawn.distance[k]),
                  f * drawn.radiance * (wi.z / drawn.pdf[k]));
      }
      if (!group.is_full() && i + 1 < draws) continue;

      const std::uint32_t blocked = occluded(std::span(group.shadow_rays.data(), group.count));
      for (std::size_t j = 0; j < group.count; ++j) {
        if ((blocked >> j & 1) == 0) of_this_light += group.light[j];
      }
      group.count = 0;
    }
    sum += of_this_light / draws;
  }
  return sum;
}

}  // namespace pt
