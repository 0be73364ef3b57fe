// breaks: averages_the_radiance
// Samples below a millionth are taken for black.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const Vec2 inside = samples == 1 ? Vec2{0.5, 0.5} : sampler.next_2d();
    const Ray ray =
        camera_ray(view.camera, (x + inside.x) / view.width, (y + inside.y) / view.height);
    const Rgb sample = radiance(view.scene, ray, view.settings, sampler);
    if (max_channel(sample) >= 1e-6) sum += sample;
  }
  return sum / samples;
}

}  // namespace pt
