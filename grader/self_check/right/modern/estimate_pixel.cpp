#include "pt/tasks/estimate_pixel.h"

#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"

#include <numeric>
#include <ranges>
#include <vector>
namespace pt {
// An n x n grid of strata where samples is a square, plain jitter otherwise.
Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  const auto through = [&](double dx, double dy) {
    return radiance(view.scene,
                    camera_ray(view.camera, (x + dx) / view.width, (y + dy) / view.height),
                    view.settings, sampler);
  };
  if (samples == 1) return through(.5, .5);
  int n = 1;
  while ((n + 1) * (n + 1) <= samples) ++n;
  std::vector<Rgb> all;
  all.reserve(samples);
  for (int i : std::views::iota(0, samples)) {
    const auto [u, v] = sampler.next_2d();
    all.push_back(n * n == samples ? through((i % n + u) / n, (i / n + v) / n) : through(u, v));
  }
  return std::accumulate(all.begin(), all.end(), Rgb{}) / samples;
}
}  // namespace pt
