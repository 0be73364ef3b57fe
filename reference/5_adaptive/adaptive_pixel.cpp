#include "pt/tasks/adaptive_pixel.h"

#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"

#include <cmath>

namespace pt {

namespace {

// Mean and variance of a sequence, one number at a time (Welford 1962). No term is negative, and all
// are zero for a constant; s2 - s1^2 / n may become negative by rounding.
struct RunningVariance {
  int n = 0;
  double mean = 0;
  double squares = 0;  // the sum of squared distances from the mean

  void add(double value) {
    ++n;
    const double distance = value - mean;
    mean += distance / n;
    squares += distance * (value - mean);
  }

  // Half the width of the interval that holds the true mean 95 times in 100.
  double half_interval() const { return 1.96 * std::sqrt(squares / (n - 1) / n); }
};

}  // namespace

PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  // Ends at the first n = b, 2 b, 3 b, ... with 1.96 sigma / sqrt(n) < tolerance * mean, where b is the
  // size of a batch, and mean and sigma are those of the luminance of n samples.
  Rgb sum;
  RunningVariance brightness;
  while (brightness.n < settings.max_samples) {
    const Vec2 inside = sampler.next_2d();
    const Ray ray =
        camera_ray(view.camera, (x + inside.x) / view.width, (y + inside.y) / view.height);
    const Rgb sample = radiance(view.scene, ray, view.settings, sampler);
    sum += sample;
    brightness.add(luminance(sample));

    const bool batch_ends = brightness.n % settings.batch == 0;
    if (batch_ends && brightness.half_interval() < settings.tolerance * brightness.mean) break;
  }
  return {sum / brightness.n, brightness.n};
}

}  // namespace pt
