// breaks: covers_the_whole_pixel
// The points leave out the outermost half thousandth of the pixel on all sides.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    Vec2 xi = samples == 1 ? Vec2{0.5, 0.5} : sampler.next_2d();
    if (samples > 1) xi = {0.0005 + 0.999 * xi.x, 0.0005 + 0.999 * xi.y};
    const Ray ray = camera_ray(view.camera, (x + xi.x) / view.width, (y + xi.y) / view.height);
    sum += radiance(view.scene, ray, view.settings, sampler);
  }
  return sum / samples;
}

}  // namespace pt
