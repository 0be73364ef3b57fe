#include "pt/tasks/camera_ray.h"

#include "grader/check/many.h"
#include "grader/mistakes/battery.h"

#include <array>

namespace grader::mistakes {
namespace {

using namespace check;

using pt::Camera;
using pt::Vec3;

std::vector<Camera> cameras() {
  Many make(2);
  std::vector<Camera> all;
  constexpr std::array<double, 2> kAngles[] = {{50, 38}, {90, 30}, {20, 70}, {100, 100}};
  for (const auto& [horizontal, vertical] : kAngles) {
    for (const bool moved : {false, true}) {
      Camera camera;
      camera.hfov_deg = horizontal;
      camera.vfov_deg = vertical;
      camera.near_clip = 0.25;
      camera.far_clip = 40;
      if (moved) {
        camera.position = make.vector(-4, 4);
        const pt::Frame around = pt::frame_from_normal(normalize(make.vector(-1, 1)));
        camera.camera_to_world = {around.z, around.x, around.y};
      }
      all.push_back(camera);
    }
  }
  return all;
}

}  // namespace

void run_battery(Battery& battery) {
  constexpr std::array<double, 2> kPlaces[] = {{.5, .5}, {0, .5},  {1, .5}, {.5, 0},
                                               {.5, 1},  {.1, .8}, {1, 1},  {.7, .35}};
  for (const Camera& camera : cameras()) {
    for (const auto& [x, y] : kPlaces) {
      battery.ask([&]() -> Battery::Numbers {
        const pt::Ray ray = pt::camera_ray(camera, x, y);
        const auto& [o, d] = std::pair(ray.origin, ray.direction);
        return {o.x, o.y, o.z, d.x, d.y, d.z, ray.t_min, ray.t_max};
      });
    }
  }
}

}  // namespace grader::mistakes
