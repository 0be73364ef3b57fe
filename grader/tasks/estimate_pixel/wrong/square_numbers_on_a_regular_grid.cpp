// breaks: covers_the_whole_pixel
// A square number of samples goes through the middles of a grid of cells.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <cmath>

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const int side = static_cast<int>(std::sqrt(samples) + 0.5);
    const Vec2 inside = side * side == samples
                            ? Vec2{(i % side + 0.5) / side, (i / side + 0.5) / side}
                            : sampler.next_2d();
    const Ray ray =
        camera_ray(view.camera, (x + inside.x) / view.width, (y + inside.y) / view.height);
    sum += radiance(view.scene, ray, view.settings, sampler);
  }
  return sum / samples;
}

}  // namespace pt
