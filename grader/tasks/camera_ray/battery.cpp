#include "grader/mistakes/battery.h"

#include "grader/tasks/camera_ray/inputs.h"

#include <utility>

namespace grader::mistakes {
namespace {

using namespace check;

using namespace camera_ray_inputs;

void ask(Battery& battery, const pt::Camera& camera, double x, double y) {
  battery.ask([&]() -> Battery::Numbers {
    const pt::Ray ray = call({camera, {x, y}});
    const auto& [o, d] = std::pair(ray.origin, ray.direction);
    return {o.x, o.y, o.z, d.x, d.y, d.z, ray.t_min, ray.t_max};
  });
}

}  // namespace

void run_battery(Battery& battery) {
  for (const pt::Camera& camera : ordinary()) {
    for (const auto& [x, y] : kPlaces) ask(battery, camera, x, y);
  }
  for (const pt::Camera& camera : unusual()) {
    for (const auto& [x, y] : {kPlaces[0], kPlaces[2], kPlaces[4], kPlaces[5]}) {
      ask(battery, camera, x, y);
    }
  }
  for (const pt::Camera& camera : with_ranges()) ask(battery, camera, 0.1, 0.8);
  for (const pt::Camera& camera : upright()) ask(battery, camera, 0.1, 0.8);
}

}  // namespace grader::mistakes
