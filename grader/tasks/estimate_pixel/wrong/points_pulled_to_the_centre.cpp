// breaks: covers_the_whole_pixel
// A tent filter, or the mean of two numbers: points close to the centre are more likely.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <algorithm>
#include <cmath>

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const Vec2 xi = samples == 1 ? Vec2{0.5, 0.5}
                                 : Vec2{0.5 * (sampler.next_1d() + sampler.next_1d()),
                                        0.5 * (sampler.next_1d() + sampler.next_1d())};
    const Ray ray = camera_ray(view.camera, (x + xi.x) / view.width, (y + xi.y) / view.height);
    sum += radiance(view.scene, ray, view.settings, sampler);
  }
  return sum / samples;
}

}  // namespace pt
