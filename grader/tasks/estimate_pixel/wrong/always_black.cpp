#include "pt/tasks/estimate_pixel.h"

namespace pt {

Rgb estimate_pixel(const View&, int, int, int, Sampler&) { return {}; }

}  // namespace pt
