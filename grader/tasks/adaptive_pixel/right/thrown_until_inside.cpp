// right: points are thrown at the circle around the pixel until one is inside the pixel.
#include "pt/render/radiance.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/camera_ray.h"

#include <cmath>

namespace pt {

namespace {

Vec2 thrown_into_the_pixel(Sampler& sampler) {
  for (;;) {
    const Vec2 xi = sampler.next_2d();
    const double r = std::sqrt(0.5 * xi.x), phi = 2 * kPi * xi.y;
    const Vec2 at{0.5 + r * std::cos(phi), 0.5 + r * std::sin(phi)};
    if (at.x >= 0 && at.x < 1 && at.y >= 0 && at.y < 1) return at;
  }
}

}  // namespace

PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  Rgb sum;
  double mean = 0, squares = 0;  // of the luminance: Welford (1962)
  int n = 0;
  while (n < settings.max_samples) {
    const Vec2 at = thrown_into_the_pixel(sampler);
    const Ray ray = camera_ray(view.camera, (x + at.x) / view.width, (y + at.y) / view.height);
    const Rgb sample = radiance(view.scene, ray, view.settings, sampler);
    sum += sample;
    ++n;
    const double off = luminance(sample) - mean;
    mean += off / n;
    squares += off * (luminance(sample) - mean);
    if (n % settings.batch != 0) continue;
    const double sigma = std::sqrt(squares / (n - 1));
    if (1.96 * sigma / std::sqrt(n) < settings.tolerance * mean) break;
  }
  return {sum / n, n};
}

}  // namespace pt
