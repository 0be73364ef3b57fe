// method: the variance as sum of squares minus square of sum
#include "pt/render/radiance.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/camera_ray.h"

#include <algorithm>
#include <cmath>

#ifndef REAL
#define REAL double
#endif

namespace pt {

PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  Rgb sum;
  REAL s1 = 0, s2 = 0;
  int n = 0;
  while (n < settings.max_samples) {
    const Vec2 inside = sampler.next_2d();
    const Ray ray =
        camera_ray(view.camera, (x + inside.x) / view.width, (y + inside.y) / view.height);
    const Rgb sample = radiance(view.scene, ray, view.settings, sampler);
    const REAL brightness = static_cast<REAL>(luminance(sample));
    sum += sample;
    s1 += brightness;
    s2 += brightness * brightness;
    ++n;
    if (n % settings.batch != 0) continue;

    const REAL count = static_cast<REAL>(n), mean = s1 / count;
    const REAL variance = std::max(REAL{0}, (s2 - s1 * s1 / count) / (count - 1));
    if (1.96 * std::sqrt(variance / count) < settings.tolerance * mean) break;
  }
  return {sum / n, n};
}

}  // namespace pt
