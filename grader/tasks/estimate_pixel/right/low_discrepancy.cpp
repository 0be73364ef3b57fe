// right: points that spread over the pixel more evenly than random ones.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <cmath>

namespace pt {

namespace {

// Point i of a sequence that fills the square [0, 1)^2 evenly, however many points of it are taken
// (Roberts 2018, The Unreasonable Effectiveness of Quasirandom Sequences), moved by `start`. With a start that is
// uniform in the square, so is each point (Cranley and Patterson 1976): a mean over the points has no bias.
Vec2 low_discrepancy_point(Vec2 start, int i) {
  // 1 / g and 1 / g^2, where g^3 = g + 1: the golden ratio of two dimensions.
  const double x = start.x + 0.7548776662466927 * i;
  const double y = start.y + 0.5698402909980532 * i;
  return {x - std::floor(x), y - std::floor(y)};
}

}  // namespace

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
