// right: point and sum in single precision
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  float r = 0, g = 0, b = 0;
  for (int i = 0; i < samples; ++i) {
    float dx = 0.5f, dy = 0.5f;
    if (samples > 1) {
      dx = static_cast<float>(sampler.next_1d());
      dy = static_cast<float>(sampler.next_1d());
    }
    const float u = (static_cast<float>(x) + dx) / static_cast<float>(view.width);
    const float v = (static_cast<float>(y) + dy) / static_cast<float>(view.height);
    const Rgb sample = radiance(view.scene, camera_ray(view.camera, u, v), view.settings, sampler);
    r += static_cast<float>(sample.r);
    g += static_cast<float>(sample.g);
    b += static_cast<float>(sample.b);
  }
  const float n = static_cast<float>(samples);
  return {r / n, g / n, b / n};
}

}  // namespace pt
