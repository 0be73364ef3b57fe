// right: std::function, a list of samples, std::accumulate; every second point mirrors another
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <functional>
#include <memory>
#include <numeric>
#include <vector>

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  const auto all = std::make_unique<std::vector<Rgb>>();
  const std::function<void(Vec2)> take = [&view, x, y, &all, &sampler](Vec2 at) {
    const Ray ray = camera_ray(view.camera, (x + at.x) / view.width, (y + at.y) / view.height);
    all->push_back(radiance(view.scene, ray, view.settings, sampler));
  };
  if (samples % 2 == 1) take(samples == 1 ? Vec2{0.5, 0.5} : sampler.next_2d());
  for (int pair = 0; pair < samples / 2; ++pair) {
    const Vec2 at = sampler.next_2d();
    take(at);
    take({1 - at.x, 1 - at.y});
  }
  return std::accumulate(all->begin(), all->end(), Rgb{}) / samples;
}

}  // namespace pt
