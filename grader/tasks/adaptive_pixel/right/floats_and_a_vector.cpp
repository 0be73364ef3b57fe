// right: keeps all samples of the pixel and looks at them in two passes; colors in float, sums in
// double.
#include "pt/render/radiance.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/camera_ray.h"

#include <cmath>
#include <numeric>
#include <vector>

namespace pt {

namespace {

bool is_narrow(const std::vector<float>& brightness, double tolerance) {
  const double n = static_cast<double>(brightness.size());
  const double mean = std::accumulate(brightness.begin(), brightness.end(), 0.0) / n;
  double squares = 0;
  for (const float one : brightness) squares += (one - mean) * (one - mean);
  return 1.96 * std::sqrt(squares / (n - 1)) / std::sqrt(n) < tolerance * mean;
}

}  // namespace

PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  std::vector<float> brightness;
  double r = 0, g = 0, b = 0;
  const auto count = [&] { return static_cast<int>(brightness.size()); };
  do {
    const double u = (x + sampler.next_1d()) / view.width;
    const double v = (y + sampler.next_1d()) / view.height;
    const Ray ray = camera_ray(view.camera, u, v);
    const Rgb sample = radiance(view.scene, ray, view.settings, sampler);
    const auto red = static_cast<float>(sample.r), green = static_cast<float>(sample.g),
               blue = static_cast<float>(sample.b);
    r += red;
    g += green;
    b += blue;
    brightness.push_back(0.2126F * red + 0.7152F * green + 0.0722F * blue);
    if (count() % settings.batch == 0 && is_narrow(brightness, settings.tolerance)) break;
  } while (count() < settings.max_samples);
  const double n = count();
  return {{r / n, g / n, b / n}, count()};
}

}  // namespace pt
