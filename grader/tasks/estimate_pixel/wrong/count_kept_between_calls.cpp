// breaks: forgets_the_pixel_before
// Counts down a variable that outlives the call.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <cmath>

namespace pt {

static int samples_left = -1;

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  Rgb sum;
  if (samples_left < 0) samples_left = samples;
  for (; samples_left > 0; --samples_left) {
    const Vec2 xi = samples == 1 ? Vec2{0.5, 0.5} : sampler.next_2d();
    const Ray ray = camera_ray(view.camera, (x + xi.x) / view.width, (y + xi.y) / view.height);
    sum += radiance(view.scene, ray, view.settings, sampler);
  }
  return sum / samples;
}

}  // namespace pt
