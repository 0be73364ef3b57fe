#include "pt/tasks/camera_ray.h"

#include "grader/check/random_numbers.h"
#include "grader/mistakes/battery.h"

#include <array>

namespace grader::mistakes {
namespace {

using namespace check;

using pt::Camera;

std::vector<Camera> cameras() {
  RandomNumbers make(2);
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

// Fields of view that are narrow, wide, or not in whole degrees. The last one has a range without an
// end, so that its other numbers are of the size of a direction and a small error of an angle shows.
std::vector<Camera> unusual() {
  std::vector<Camera> all(3);
  constexpr std::array<double, 2> kAngles[] = {{0.5, 0.4}, {175, 170}, {86.3, 60.7}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].hfov_deg = kAngles[i][0];
    all[i].vfov_deg = kAngles[i][1];
    all[i].near_clip = 0.25;
    all[i].far_clip = 40;
  }
  all.back().far_clip = pt::kInfinity;
  return all;
}

// Ranges that end at a billion, that begin at 20, and that are a single distance.
std::vector<Camera> ranges() {
  std::vector<Camera> all(3);
  constexpr std::array<double, 2> kClips[] = {{0.25, 1e9}, {20, 40}, {2, 2}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].near_clip = kClips[i][0];
    all[i].far_clip = kClips[i][1];
  }
  return all;
}

// A camera that looks straight up (1) or straight down (-1). The right of its picture is along the
// world's z.
Camera upright(double up) {
  Camera camera;
  camera.camera_to_world = {{0, 0, 1}, {-up, 0, 0}, {0, -up, 0}};
  camera.near_clip = 0.25;
  camera.far_clip = 40;
  return camera;
}

void ask(Battery& battery, const Camera& camera, double x, double y) {
  battery.ask([&]() -> Battery::Numbers {
    const pt::Ray ray = pt::camera_ray(camera, x, y);
    const auto& [o, d] = std::pair(ray.origin, ray.direction);
    return {o.x, o.y, o.z, d.x, d.y, d.z, ray.t_min, ray.t_max};
  });
}

}  // namespace

void run_battery(Battery& battery) {
  constexpr std::array<double, 2> kPlaces[] = {{.5, .5}, {0, .5},  {1, .5}, {.5, 0},
                                               {.5, 1},  {.1, .8}, {1, 1},  {.7, .35}};
  for (const Camera& camera : cameras()) {
    for (const auto& [x, y] : kPlaces) ask(battery, camera, x, y);
  }
  for (const Camera& camera : unusual()) {
    for (const auto& [x, y] : {kPlaces[0], kPlaces[2], kPlaces[4], kPlaces[5]}) {
      ask(battery, camera, x, y);
    }
  }
  for (const Camera& camera : ranges()) ask(battery, camera, 0.1, 0.8);
  for (const double up : {1.0, -1.0}) ask(battery, upright(up), 0.1, 0.8);
}

}  // namespace grader::mistakes
