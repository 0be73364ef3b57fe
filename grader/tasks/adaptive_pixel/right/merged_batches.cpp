// right: the mean and the variance of each batch by itself, merged with those before it (Chan, Golub
// and LeVeque 1983).
#include "pt/render/radiance.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/camera_ray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pt {

namespace {

struct Statistics {
  double n = 0, mean = 0, squares = 0;  // squares: the sum of the squared deviations from the mean
  Rgb sum;

  void merge(const Statistics& other) {
    const double off = other.mean - mean, all = n + other.n;
    squares += other.squares + off * off * n * other.n / all;
    mean += off * other.n / all;
    n = all;
    sum += other.sum;
  }

  // Half of the 95 % interval of the mean.
  double half() const { return 1.96 * std::sqrt(squares / (n - 1) / n); }
};

Statistics statistics_of(const std::vector<Rgb>& samples) {
  Statistics all;
  for (const Rgb& sample : samples) {
    all.sum += sample;
    all.mean += luminance(sample);
    ++all.n;
  }
  all.mean /= all.n;
  for (const Rgb& sample : samples) all.squares += std::pow(luminance(sample) - all.mean, 2);
  return all;
}

}  // namespace

PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  Statistics all;
  int left = settings.max_samples;
  while (left > 0 && !(all.n > 0 && all.half() < settings.tolerance * all.mean)) {
    std::vector<Rgb> batch;
    for (int i = std::min(left, settings.batch); i > 0; --i, --left) {
      const Vec2 xi = sampler.next_2d();
      const Ray ray = camera_ray(view.camera, (x + xi.x) / view.width, (y + xi.y) / view.height);
      batch.push_back(radiance(view.scene, ray, view.settings, sampler));
    }
    all.merge(statistics_of(batch));
  }
  return {all.sum / all.n, settings.max_samples - left};
}

}  // namespace pt
