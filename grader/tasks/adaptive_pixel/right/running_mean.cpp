// right: means that move with each sample, and one squared comparison without a root.
#include "pt/render/radiance.h"
#include "pt/tasks/adaptive_pixel.h"
#include "pt/tasks/camera_ray.h"

namespace pt {

PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  PixelEstimate pixel;
  double mean = 0, m2 = 0;
  for (;;) {
    for (int i = 0; i < settings.batch && pixel.samples < settings.max_samples; ++i) {
      const Vec2 xi = sampler.next_2d();
      const Ray ray = camera_ray(view.camera, (x + xi.x) / view.width, (y + xi.y) / view.height);
      const Rgb sample = radiance(view.scene, ray, view.settings, sampler);
      const double n = ++pixel.samples;
      pixel.mean += (sample - pixel.mean) / n;
      const double off = luminance(sample) - mean;
      mean += off / n;
      m2 += off * (luminance(sample) - mean);
    }
    if (pixel.samples == settings.max_samples) return pixel;
    const double n = pixel.samples;
    const double half_squared = 1.96 * 1.96 * m2 / (n * (n - 1));
    const double limit = settings.tolerance * mean;
    if (half_squared < limit * limit) return pixel;
  }
}

}  // namespace pt
