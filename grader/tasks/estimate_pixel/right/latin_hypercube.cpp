// right: every column and every row of the pixel holds one sample (Latin hypercube); each point is
// uniform by itself.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <numeric>
#include <utility>
#include <vector>

namespace pt {
namespace {
std::vector<int> shuffled(int n, Sampler& sampler) {
  std::vector<int> v(static_cast<std::size_t>(n));
  std::iota(v.begin(), v.end(), 0);
  for (int i = n - 1; i > 0; --i)
    std::swap(v[static_cast<std::size_t>(i)],
              v[static_cast<std::size_t>(sampler.next_1d() * (i + 1))]);
  return v;
}
}  // namespace

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  if (samples == 1) {
    return radiance(view.scene,
                    camera_ray(view.camera, (x + .5) / view.width, (y + .5) / view.height),
                    view.settings, sampler);
  }
  const auto rows = shuffled(samples, sampler);
  const auto cols = shuffled(samples, sampler);
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const double jx = (cols[static_cast<std::size_t>(i)] + sampler.next_1d()) / samples;
    const double jy = (rows[static_cast<std::size_t>(i)] + sampler.next_1d()) / samples;
    sum +=
        radiance(view.scene, camera_ray(view.camera, (x + jx) / view.width, (y + jy) / view.height),
                 view.settings, sampler);
  }
  return sum / samples;
}
}  // namespace pt
