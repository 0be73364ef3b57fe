#include "pt/tasks/adaptive_pixel.h"

#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"

#include <algorithm>
#include <cmath>
namespace pt {
PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  Rgb sum;
  double s1 = 0, s2 = 0;
  int n = 0;
  while (n < settings.max_samples) {
    for (int i = 0; i < settings.batch && n < settings.max_samples; i++) {
      Vec2 u = sampler.next_2d();
      Rgb c = radiance(view.scene,
                       camera_ray(view.camera, (x + u.x) / view.width, (y + u.y) / view.height),
                       view.settings, sampler);
      double l = luminance(c);
      s1 += l;
      s2 += l * l;
      sum += c;
      n++;
    }
    double mean = s1 / n, var = std::max(0.0, (s2 - s1 * s1 / n) / (n - 1));
    if (1.96 * std::sqrt(var / n) <= settings.tolerance * mean && s1 > 0) break;
  }
  return {sum / n, n};
}
}  // namespace pt
