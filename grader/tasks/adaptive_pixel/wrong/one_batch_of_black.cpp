// breaks: never_exceeds_the_maximum
// Says that it took one batch, and traces nothing.
#include "pt/tasks/adaptive_pixel.h"

namespace pt {

PixelEstimate adaptive_pixel(const View&, int, int, const AdaptiveSettings& settings, Sampler&) {
  return {{}, settings.batch};
}

}  // namespace pt
