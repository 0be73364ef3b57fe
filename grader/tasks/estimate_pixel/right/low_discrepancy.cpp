// right: points that spread over the pixel more evenly than random ones.
#include "pt/render/radiance.h"
#include "pt/sampling/quasirandom.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  const Vec2 start = samples == 1 ? Vec2{0.5, 0.5} : sampler.next_2d();
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const Vec2 at = low_discrepancy_point(start, i);
    const Ray ray = camera_ray(view.camera, (x + at.x) / view.width, (y + at.y) / view.height);
    sum += radiance(view.scene, ray, view.settings, sampler);
  }
  return sum / samples;
}

}  // namespace pt
