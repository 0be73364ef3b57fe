#include "pt/render/path_radiance.h"
#include "pt/render/pixel_record.h"

namespace pt {

PixelRecord& pixel_record() {
  static thread_local PixelRecord record;
  return record;
}

Rgb radiance(const Scene& scene, const Ray& ray, const PathSettings& settings, Sampler& sampler) {
  const Rgb sample = path_radiance(scene, ray, settings, sampler);
  PixelRecord& record = pixel_record();
  if (!is_finite(sample)) {
    ++record.not_finite;
    return {};
  }
  record.moments.add(sample);
  return sample;
}

}  // namespace pt
