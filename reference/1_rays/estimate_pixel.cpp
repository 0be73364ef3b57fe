#include "pt/tasks/estimate_pixel.h"

#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    // One sample goes through the centre, so that every picture shows the same points.
    const Vec2 inside = samples == 1 ? Vec2{0.5, 0.5} : sampler.next_2d();
    const Ray ray =
        camera_ray(view.camera, (x + inside.x) / view.width, (y + inside.y) / view.height);
    sum += radiance(view.scene, ray, view.settings, sampler);
  }
  return sum / samples;
}

}  // namespace pt
