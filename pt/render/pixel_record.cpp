#include "pt/render/pixel_record.h"

namespace pt {

PixelRecord& pixel_record() {
  static thread_local PixelRecord record;
  return record;
}

Rgb recorded(Rgb sample) {
  PixelRecord& record = pixel_record();
  if (!is_finite(sample)) {
    ++record.not_finite;
    return {};
  }
  record.moments.add(sample);
  return sample;
}

}  // namespace pt
