// right: stratified jitter: as many cells as there are whole rows of samples, the rest anywhere
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <cmath>

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  const int rows = static_cast<int>(std::sqrt(static_cast<double>(samples)));
  Rgb mean;
  for (int i = 0; i < samples; ++i) {
    Vec2 at{0.5, 0.5};
    if (samples > 1) at = sampler.next_2d();
    if (i < rows * rows && samples > 1) at = {(i % rows + at.x) / rows, (i / rows + at.y) / rows};
    const Ray ray = camera_ray(view.camera, (x + at.x) / view.width, (y + at.y) / view.height);
    mean += radiance(view.scene, ray, view.settings, sampler) / samples;
  }
  return mean;
}

}  // namespace pt
