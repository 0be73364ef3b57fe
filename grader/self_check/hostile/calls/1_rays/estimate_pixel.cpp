// Lets another task estimate the pixel.
#include "pt/tasks/estimate_pixel.h"

#include "pt/tasks/camera_ray.h"

namespace pt {

struct AdaptiveSettings {
  int max_samples, batch;
  double tolerance;
};
struct PixelEstimate {
  Rgb mean;
  int samples;
};
PixelEstimate adaptive_pixel(const View&, int, int, const AdaptiveSettings&, Sampler&);

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  return adaptive_pixel(view, x, y, {samples, samples, 1}, sampler).mean;
}

}  // namespace pt
