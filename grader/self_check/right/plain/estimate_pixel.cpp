#include "pt/tasks/estimate_pixel.h"

#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
namespace pt {
Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  float r = 0, g = 0, b = 0;
  for (int i = 0; i < samples; i++) {
    double dx = 0.5, dy = 0.5;
    if (samples > 1) {
      dx = sampler.next_1d();
      dy = sampler.next_1d();
    }
    Ray ray =
        camera_ray(view.camera, (x + dx) / double(view.width), (y + dy) / double(view.height));
    Rgb c = radiance(view.scene, ray, view.settings, sampler);
    r += float(c.r);
    g += float(c.g);
    b += float(c.b);
  }
  return Rgb{r / samples, g / samples, b / samples};
}
}  // namespace pt
