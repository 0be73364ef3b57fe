// breaks: draws_from_the_callers_sampler
// Makes a sampler of its own from the pixel, whatever the caller's seed.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <algorithm>
#include <cmath>

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  Sampler own = Sampler::for_pixel(1, x, y);
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const Vec2 xi = samples == 1 ? Vec2{0.5, 0.5} : own.next_2d();
    const Ray ray = camera_ray(view.camera, (x + xi.x) / view.width, (y + xi.y) / view.height);
    sum += radiance(view.scene, ray, view.settings, own);
  }
  return sum / samples;
}

}  // namespace pt
