#include "bench/ray_sets.h"

#include "pt/geometry/spawn_ray.h"
#include "pt/sampling/directions.h"
#include "pt/tasks/camera_ray.h"

namespace pt {

namespace {

constexpr int kWidth = 480;
constexpr int kHeight = 360;

// Adds rays towards random lights, if light from them arrives.
void add_shadow_rays(const Scene& scene, const SurfacePoint& point, Sampler& sampler,
                     std::vector<Ray>& rays) {
  if (scene.lights.empty()) return;
  std::vector<Ray> group;
  for (int attempt = 0; attempt < 4 * kShadowGroup; ++attempt) {
    const auto which =
        static_cast<std::size_t>(sampler.next_1d() * static_cast<double>(scene.lights.size()));
    const LightSample sample = sample_light(scene.lights[which], point.p, sampler);
    if (!(dot(sample.wi, point.n) > 0) || is_black(sample.radiance)) continue;
    group.push_back(shadow_ray(point, sample.wi, sample.distance));
    if (group.size() == kShadowGroup) {
      rays.insert(rays.end(), group.begin(), group.end());
      return;
    }
  }
}

}  // namespace

RaySets make_rays(const TestScene& test, int count) {
  RaySets sets;
  Sampler sampler(1);
  const Scene& scene = test.scene;
  const int pixels = kWidth * kHeight;
  const auto wanted = static_cast<std::size_t>(count);
  const auto full = [&](const std::vector<Ray>& rays) { return rays.size() >= wanted; };
  for (int i = 0; i < 64 * count && !(full(sets.primary) && full(sets.bounce)); ++i) {
    const int pixel = static_cast<int>(static_cast<long long>(i) * pixels / count) % pixels;
    const Vec2 xi = sampler.next_2d();
    const int x = pixel % kWidth, y = pixel / kWidth;
    Ray ray = camera_ray(test.camera, (x + xi.x) / kWidth, (y + xi.y) / kHeight);
    if (!full(sets.primary)) sets.primary.push_back(ray);
    for (int bounce = 0; bounce < 2; ++bounce) {
      const std::optional<Hit> hit = scene.closest(ray);
      if (!hit) break;
      const SurfacePoint point = surface_point(scene, ray, *hit);
      if (i % 8 == 0 && !full(sets.shadow)) add_shadow_rays(scene, point, sampler, sets.shadow);
      ray = spawn_ray(point, point.frame.to_world(cosine_hemisphere(sampler.next_2d())));
      if (!full(sets.bounce)) sets.bounce.push_back(ray);
    }
  }
  return sets;
}

}  // namespace pt
