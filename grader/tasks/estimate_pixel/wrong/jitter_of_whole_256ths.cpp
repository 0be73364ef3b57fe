// breaks: covers_the_whole_pixel
// The points lie on a grid of 256 x 256 places of the pixel.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    Vec2 inside = samples == 1 ? Vec2{0.5, 0.5} : sampler.next_2d();
    inside = {static_cast<int>(inside.x * 256) / 256.0, static_cast<int>(inside.y * 256) / 256.0};
    const Ray ray =
        camera_ray(view.camera, (x + inside.x) / view.width, (y + inside.y) / view.height);
    sum += radiance(view.scene, ray, view.settings, sampler);
  }
  return sum / samples;
}

}  // namespace pt
