// right: it draws a point for a single sample too, and does not use it
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    Vec2 inside = sampler.next_2d();
    if (samples == 1) inside = {0.5, 0.5};
    const Ray ray =
        camera_ray(view.camera, (x + inside.x) / view.width, (y + inside.y) / view.height);
    sum += radiance(view.scene, ray, view.settings, sampler);
  }
  return sum / samples;
}

}  // namespace pt
