#include "pt/render/common_radiance.h"
#include "pt/render/pixel_record.h"

namespace pt {

Rgb radiance(const Scene& scene, const Ray& ray, const PathSettings& settings, Sampler& sampler) {
  return recorded(common_radiance(scene, ray, settings, sampler));
}

}  // namespace pt
