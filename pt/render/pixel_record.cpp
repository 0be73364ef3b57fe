#include "pt/render/pixel_record.h"

#include <cmath>
#include <limits>

namespace pt {

PixelRecord& pixel_record() {
  static thread_local PixelRecord record;
  return record;
}

bool fits_float(Rgb radiance) {
  constexpr double kMax = std::numeric_limits<float>::max();
  return std::abs(radiance.r) <= kMax && std::abs(radiance.g) <= kMax &&
         std::abs(radiance.b) <= kMax;
}

Rgb recorded(Rgb sample) {
  PixelRecord& record = pixel_record();
  if (!fits_float(sample)) {
    ++record.not_finite;
    return {};
  }
  record.moments.add(sample);
  return sample;
}

}  // namespace pt
