// breaks: averages_the_radiance
// Divides by the counter after the loop, and adds one.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <algorithm>
#include <cmath>

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  Rgb sum;
  int i = 0;
  for (; i < samples; ++i) {
    const Vec2 xi = samples == 1 ? Vec2{0.5, 0.5} : sampler.next_2d();
    const Ray ray = camera_ray(view.camera, (x + xi.x) / view.width, (y + xi.y) / view.height);
    sum += radiance(view.scene, ray, view.settings, sampler);
  }
  return sum / (i + 1);
}

}  // namespace pt
