// breaks: takes_one_batch_of_a_constant
// s2 - s1^2 / n in float: the rounding errors of a constant look like noise.
#include "pt/render/radiance.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/camera_ray.h"

#include <algorithm>
#include <cmath>

namespace pt {

PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  Rgb sum;
  float s1 = 0, s2 = 0;
  int n = 0;
  while (n < settings.max_samples) {
    const Vec2 inside = sampler.next_2d();
    const Ray ray =
        camera_ray(view.camera, (x + inside.x) / view.width, (y + inside.y) / view.height);
    const Rgb sample = radiance(view.scene, ray, view.settings, sampler);
    const float brightness = static_cast<float>(luminance(sample));
    sum += sample;
    s1 += brightness;
    s2 += brightness * brightness;
    ++n;
    if (n % settings.batch != 0) continue;

    const float mean = s1 / static_cast<float>(n);
    const double variance = std::max(
        0.0,
        static_cast<double>((s2 - s1 * s1 / static_cast<float>(n)) / static_cast<float>(n - 1)));
    if (1.96 * std::sqrt(variance / n) < settings.tolerance * mean) break;
  }
  return {sum / n, n};
}

}  // namespace pt
