// Ordinary inputs: any camera with fields of view from 20 to 120 degrees, and any point of its picture.
#include "pt/tasks/camera_ray.h"

#include "pt/examples/example.h"
#include "pt/examples/inputs.h"

#include <cmath>

using namespace pt;
using namespace pt::inputs;

EXAMPLE("less than 1 in 100 ordinary inputs differs") {
  Sampler sampler(1);
  int differ = 0;
  constexpr int kInputs = 20000;
  for (int i = 0; i < kInputs; ++i) {
    Camera camera;
    camera.position = 5 * any_vector(sampler);
    const Vec3 back = normalize(any_vector(sampler) + Vec3{1e-3, 0, 0});
    camera.camera_to_world = frame_from_normal(back);
    camera.hfov_deg = 20 + 100 * sampler.next_1d();
    camera.vfov_deg = 20 + 100 * sampler.next_1d();
    camera.near_clip = sampler.next_1d();
    camera.far_clip = 10 + sampler.next_1d();
    const Vec2 at = sampler.next_2d();
    const Ray ray = camera_ray(camera, at.x, at.y);
    const double degree = std::acos(-1.0) / 180;
    const Vec3 local{(2 * at.x - 1) * std::tan(camera.hfov_deg / 2 * degree),
                     (2 * at.y - 1) * std::tan(camera.vfov_deg / 2 * degree), -1};
    const Vec3 direction = normalize(camera.camera_to_world.to_world(local));
    const bool same = length(ray.origin - camera.position) <= 1e-4 &&
                      length(ray.direction - direction) <= 1e-4 &&
                      std::abs(ray.t_min - camera.near_clip) <= 1e-4 &&
                      std::abs(ray.t_max - camera.far_clip) <= 1e-4;
    if (!same) ++differ;
  }
  EXPECT(differ < kInputs / 100);
}
