// right: points that spread over the pixel more evenly than random ones, wherever it stops.
#include "pt/render/radiance.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/camera_ray.h"

#include <cmath>

namespace pt {

namespace {

// Point i of a sequence that fills the square [0, 1)^2 evenly, however many points of it are taken
// (Roberts 2018, The Unreasonable Effectiveness of Quasirandom Sequences), moved by `start`. With a start that is
// uniform in the square, so is each point (Cranley and Patterson 1976): a mean over the points has no bias.
Vec2 low_discrepancy_point(Vec2 start, int i) {
  // 1 / g and 1 / g^2, where g^3 = g + 1: the golden ratio of two dimensions.
  const double x = start.x + 0.7548776662466927 * i;
  const double y = start.y + 0.5698402909980532 * i;
  return {x - std::floor(x), y - std::floor(y)};
}

}  // namespace

PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  const Vec2 start = sampler.next_2d();
  Rgb sum;
  double mean = 0, squares = 0;  // of the luminance, one sample at a time (Welford 1962)
  for (int n = 1;; ++n) {
    const Vec2 at = low_discrepancy_point(start, n - 1);
    const Ray ray = camera_ray(view.camera, (x + at.x) / view.width, (y + at.y) / view.height);
    const Rgb sample = radiance(view.scene, ray, view.settings, sampler);
    sum += sample;
    const double distance = luminance(sample) - mean;
    mean += distance / n;
    squares += distance * (luminance(sample) - mean);

    const bool is_narrow = n % settings.batch == 0 &&
                           1.96 * std::sqrt(squares / (n - 1) / n) < settings.tolerance * mean;
    if (is_narrow || n == settings.max_samples) return {sum / n, n};
  }
}

}  // namespace pt
