// breaks: covers_the_whole_pixel
// Moves each point to the middle of one of 16 x 16 parts of the pixel.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <algorithm>
#include <cmath>
namespace pt {
Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    Vec2 xi{0.5, 0.5};
    if (samples > 1)
      xi = sampler.next_2d(),
      xi = {(std::floor(xi.x * 16) + 0.5) / 16, (std::floor(xi.y * 16) + 0.5) / 16};
    const Ray ray = camera_ray(view.camera, (x + xi.x) / view.width, (y + xi.y) / view.height);
    sum += radiance(view.scene, ray, view.settings, sampler);
  }
  return sum / samples;
}
}  // namespace pt
