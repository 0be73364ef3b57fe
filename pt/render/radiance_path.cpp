#include "pt/render/path_radiance.h"

namespace pt {

Rgb radiance(const Scene& scene, const Ray& ray, const PathSettings& settings, Sampler& sampler) {
  return path_radiance(scene, ray, settings, sampler);
}

}  // namespace pt
