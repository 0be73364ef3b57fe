// Lets estimate_pixel take every sample.
#include "pt/tasks/adaptive_pixel.h"

namespace pt {

Rgb estimate_pixel(const View&, int x, int y, int samples, Sampler&);

PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  return {estimate_pixel(view, x, y, settings.max_samples, sampler), settings.max_samples};
}

}  // namespace pt
