#include "pt/render/radiance.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/camera_ray.h"

#include <algorithm>
#include <cmath>
namespace pt {
PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  Rgb sum;
  int n = 0;
  double mean = 0, m2 = 0;
  while (n < settings.max_samples) {
    const double row = n % settings.batch;
    const double u = sampler.next_1d();
    const Vec2 xi{u, (row + sampler.next_1d()) / settings.batch};
    const Rgb L = radiance(
        view.scene, camera_ray(view.camera, (x + xi.x) / view.width, (y + xi.y) / view.height),
        view.settings, sampler);
    sum += L;
    ++n;
    const double v = luminance(L), d = v - mean;
    mean += d / n;
    m2 += d * (v - mean);
    if (n % settings.batch != 0) continue;
    const double sigma = std::sqrt(m2 / (n - 1));
    if (1.96 * sigma / std::sqrt(n) < settings.tolerance * mean) break;
  }
  return {sum / n, n};
}
}  // namespace pt
