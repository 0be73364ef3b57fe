// breaks: takes_one_batch_of_a_constant
// Returns black and no sample, and traces nothing.
#include "pt/tasks/adaptive_pixel.h"

namespace pt {

PixelEstimate adaptive_pixel(const View&, int, int, const AdaptiveSettings&, Sampler&) {
  return {};
}

}  // namespace pt
