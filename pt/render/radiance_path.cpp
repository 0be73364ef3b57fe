#include "pt/render/common_radiance.h"

namespace pt {

Rgb radiance(const Scene& scene, const Ray& ray, const PathSettings& settings, Sampler& sampler) {
  return common_radiance(scene, ray, settings, sampler);
}

}  // namespace pt
