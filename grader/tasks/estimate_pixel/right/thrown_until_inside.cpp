// right: points are thrown at the circle around the pixel until one is inside the pixel.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <cmath>

namespace pt {

namespace {

Vec2 thrown_into_the_pixel(Sampler& sampler) {
  for (;;) {
    const Vec2 xi = sampler.next_2d();
    const double r = std::sqrt(0.5 * xi.x), phi = 2 * kPi * xi.y;
    const Vec2 at{0.5 + r * std::cos(phi), 0.5 + r * std::sin(phi)};
    if (at.x >= 0 && at.x < 1 && at.y >= 0 && at.y < 1) return at;
  }
}

}  // namespace

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  Rgb sum;
  for (int i = 0; i < samples; ++i) {
    const Vec2 at = samples == 1 ? Vec2{0.5, 0.5} : thrown_into_the_pixel(sampler);
    const Ray ray = camera_ray(view.camera, (x + at.x) / view.width, (y + at.y) / view.height);
    sum += radiance(view.scene, ray, view.settings, sampler);
  }
  return sum / samples;
}

}  // namespace pt
