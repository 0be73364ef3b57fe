#include "pt/render/radiance.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/camera_ray.h"

#include <algorithm>
#include <cmath>

namespace pt {

PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  static Rgb sum;
  static double s1 = 0, s2 = 0;
  static bool full = true;
  if (full) {
    sum = {};
    s1 = s2 = 0;
  }
  int n = 0;
  while (n < settings.max_samples) {
    const Vec2 inside = sampler.next_2d();
    const Ray ray =
        camera_ray(view.camera, (x + inside.x) / view.width, (y + inside.y) / view.height);
    const Rgb sample = radiance(view.scene, ray, view.settings, sampler);
    const double brightness = luminance(sample);
    sum += sample;
    s1 += brightness;
    s2 += brightness * brightness;
    ++n;
    if (n % settings.batch != 0) continue;

    const double mean = s1 / n;
    const double variance = std::max(0.0, (s2 - s1 * s1 / n) / (n - 1));
    if (1.96 * std::sqrt(variance / n) < settings.tolerance * mean) break;
  }
  full = n >= settings.max_samples;
  return {sum / n, n};
}

}  // namespace pt
