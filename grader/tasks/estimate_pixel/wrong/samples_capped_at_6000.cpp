// breaks: takes_the_samples_asked_for
// Takes 6000 samples at most.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <algorithm>
#include <cmath>
namespace pt {
Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  samples = std::min(samples, 6000);
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    Vec2 xi{0.5, 0.5};
    if (samples > 1) xi = sampler.next_2d();
    const Ray ray = camera_ray(view.camera, (x + xi.x) / view.width, (y + xi.y) / view.height);
    sum += radiance(view.scene, ray, view.settings, sampler);
  }
  return sum / samples;
}
}  // namespace pt
