// breaks: covers_the_whole_pixel
// Up to 16 samples have fixed heights in the pixel, by the golden ratio and without a random start.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    Vec2 inside = samples == 1 ? Vec2{0.5, 0.5} : sampler.next_2d();
    if (samples > 2 && samples <= 16)
      inside = {(i + inside.x) / samples, i * 0.618034 - static_cast<int>(i * 0.618034)};
    const Ray ray =
        camera_ray(view.camera, (x + inside.x) / view.width, (y + inside.y) / view.height);
    sum += radiance(view.scene, ray, view.settings, sampler);
  }
  return sum / samples;
}

}  // namespace pt
