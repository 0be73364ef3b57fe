#include "pt/tasks/adaptive_pixel.h"

#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"

#include <cmath>
#include <numeric>
#include <vector>
namespace pt {
// Keeps all samples; two passes at each check.
PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  std::vector<double> lum;
  Rgb sum;
  do {
    const double u = sampler.next_1d(), v = sampler.next_1d();
    const Rgb c =
        radiance(view.scene, camera_ray(view.camera, (x + u) / view.width, (y + v) / view.height),
                 view.settings, sampler);
    sum += c;
    lum.push_back(luminance(c));
    if (lum.size() % settings.batch) continue;
    const double n = double(lum.size());
    const double mu = std::accumulate(lum.begin(), lum.end(), 0.) / n;
    double ss = 0;
    for (double l : lum) ss += (l - mu) * (l - mu);
    const double sigma = std::sqrt(ss / n);
    if (1.96 * sigma / std::sqrt(n) < settings.tolerance * mu) break;
  } while (int(lum.size()) < settings.max_samples);
  return {sum / double(lum.size()), int(lum.size())};
}
}  // namespace pt
