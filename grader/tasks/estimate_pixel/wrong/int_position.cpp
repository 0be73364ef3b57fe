// breaks: covers_the_whole_pixel
// Keeps the point in ints, so that every ray goes through the lower left corner.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <algorithm>
#include <cmath>

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const Vec2 xi = samples == 1 ? Vec2{0.5, 0.5} : sampler.next_2d();
    const int px = static_cast<int>(x + xi.x), py = static_cast<int>(y + xi.y);
    const Ray ray = camera_ray(view.camera, px * 1.0 / view.width, py * 1.0 / view.height);
    sum += radiance(view.scene, ray, view.settings, sampler);
  }
  return sum / samples;
}

}  // namespace pt
