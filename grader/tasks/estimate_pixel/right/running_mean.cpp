// right: the points drawn first, then a running mean
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <vector>

namespace pt {

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  std::vector<Vec2> points;
  while (static_cast<int>(points.size()) < samples) points.push_back(sampler.next_2d());
  if (samples == 1) points = {{0.5, 0.5}};
  Rgb mean;
  int n = 0;
  for (const Vec2 at : points) {
    const Ray ray = camera_ray(view.camera, (x + at.x) / view.width, (y + at.y) / view.height);
    mean += (radiance(view.scene, ray, view.settings, sampler) - mean) / ++n;
  }
  return mean;
}

}  // namespace pt
