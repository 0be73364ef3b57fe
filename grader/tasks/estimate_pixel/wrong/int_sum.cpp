#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <algorithm>
#include <cmath>

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  int r = 0, g = 0, b = 0;
  for (int i = 0; i < samples; ++i) {
    const Vec2 xi = samples == 1 ? Vec2{0.5, 0.5} : sampler.next_2d();
    const Ray ray = camera_ray(view.camera, (x + xi.x) / view.width, (y + xi.y) / view.height);
    const Rgb sample = radiance(view.scene, ray, view.settings, sampler);
    r += static_cast<int>(sample.r);
    g += static_cast<int>(sample.g);
    b += static_cast<int>(sample.b);
  }
  return Rgb{r * 1.0, g * 1.0, b * 1.0} / samples;
}

}  // namespace pt
