#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <cmath>

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  Rgb sum;
  const Sampler start = sampler;
  for (int i = 0; i < samples; ++i) {
    const Vec2 xi = samples == 1 ? Vec2{0.5, 0.5} : sampler.next_2d();
    const Ray ray = camera_ray(view.camera, (x + xi.x) / view.width, (y + xi.y) / view.height);
    Sampler copy = sampler;
    sum += radiance(view.scene, ray, view.settings, copy);
  }
  sampler = start;
  return sum / samples;
}

}  // namespace pt
