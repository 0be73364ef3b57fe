#include "bench/render_tracing.h"
#include "pt/geometry/spawn_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"

#include <array>

namespace pt {

namespace {

constexpr int kGroup = 8;

// Draws that bring light if nothing is in their way.
struct Group {
  std::array<Ray, kGroup> rays;
  std::array<Rgb, kGroup> light;
  int count = 0;
};

std::uint32_t blocked(const Scene& scene, const Group& group) {
  const std::span<const Ray> rays(group.rays.data(), static_cast<std::size_t>(group.count));
  if (render_tracing.groups) {
    if (render_tracing.embree) return render_tracing.embree->occluded8(rays);
    return scene.occluded(rays);
  }
  std::uint32_t result = 0;
  for (int i = 0; i < group.count; ++i) {
    result |= static_cast<std::uint32_t>(scene.occluded(rays[i])) << i;
  }
  return result;
}

Rgb take(const Scene& scene, Group& group) {
  Rgb sum;
  const std::uint32_t mask = blocked(scene, group);
  for (int i = 0; i < group.count; ++i) {
    if ((mask >> i & 1) == 0) sum += group.light[i];
  }
  group.count = 0;
  return sum;
}

}  // namespace

// As the reference does, but that shadow rays are gathered first. The samples are the same.
Rgb direct_lights(const Scene& scene, const SurfacePoint& point, int samples, Sampler& sampler) {
  const Vec3 wo = point.frame.to_local(point.wo);
  Rgb sum;
  for (const Light& light : scene.lights) {
    const int draws = is_delta(light) ? 1 : samples;
    Rgb of_this_light;
    Group group;
    for (int i = 0; i < draws; ++i) {
      const LightSample sample = sample_light(light, point.p, sampler);
      const Vec3 wi = point.frame.to_local(sample.wi);
      if (!(wi.z > 0) || is_black(sample.radiance)) continue;
      group.rays[group.count] = shadow_ray(point, sample.wi, sample.distance);
      group.light[group.count] =
          diffuse_f(point.albedo, wo, wi) * sample.radiance * (wi.z / sample.pdf);
      if (++group.count == kGroup) of_this_light += take(scene, group);
    }
    of_this_light += take(scene, group);
    sum += of_this_light / draws;
  }
  return sum;
}

}  // namespace pt
