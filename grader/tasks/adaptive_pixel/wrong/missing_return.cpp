// breaks: stops_where_the_interval_is_narrow
// The check of a batch never returns what it found.
#include "pt/render/radiance.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/camera_ray.h"

#include <algorithm>
#include <cmath>

namespace pt {

namespace {

bool narrow(double squares, double mean, int n, double tolerance) {
  const bool done = 1.96 * std::sqrt(squares) / n < tolerance * mean;
  if (done) return true;
}

}  // namespace

PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  Rgb sum;
  double mean = 0, squares = 0;
  int n = 0;
  bool done = false;
  while (!done && n < settings.max_samples) {
    const int end = std::min(n + settings.batch, settings.max_samples);
    while (n < end) {
      const double sx = x + sampler.next_1d(), sy = y + sampler.next_1d();
      const Ray ray = camera_ray(view.camera, sx / view.width, sy / view.height);
      const Rgb sample = radiance(view.scene, ray, view.settings, sampler);
      sum += sample;
      ++n;
      const double from_mean = luminance(sample) - mean;
      mean += from_mean / n;
      squares += from_mean * (luminance(sample) - mean);
    }
    done = narrow(squares, mean, n, settings.tolerance);
  }
  return {sum / n, n};
}

}  // namespace pt
