// right: the quantile of the normal distribution to seven digits, 1.959964, for 1.96.
#include "pt/render/radiance.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/camera_ray.h"

#include <cmath>

namespace pt {

PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  constexpr double kQuantile = 1.959964;
  Rgb sum;
  double mean = 0, squares = 0;  // of the luminance, and of its distance from the mean (Welford)
  int n = 0;
  while (n < settings.max_samples) {
    const Vec2 xi = sampler.next_2d();
    const Ray ray = camera_ray(view.camera, (x + xi.x) / view.width, (y + xi.y) / view.height);
    const Rgb sample = radiance(view.scene, ray, view.settings, sampler);
    sum += sample;
    ++n;
    const double off = luminance(sample) - mean;
    mean += off / n;
    squares += off * (luminance(sample) - mean);
    const bool is_end_of_batch = n % settings.batch == 0;
    const double deviation = std::sqrt(squares / n);
    if (is_end_of_batch && kQuantile * deviation / std::sqrt(n) < settings.tolerance * mean) break;
  }
  return {sum / n, n};
}

}  // namespace pt
