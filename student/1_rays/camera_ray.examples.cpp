#include "pt/tasks/camera_ray.h"

#include "pt/examples/example.h"

using namespace pt;

// A camera at (0, 0, 3) that looks along -z: its window is 2 wide and 2 high.
const Camera square{{0, 0, 3}, {}, 90, 90};

EXAMPLE("the centre is straight ahead") {
  const Ray ray = camera_ray(square, 0.5, 0.5);
  NEAR(ray.origin, {0, 0, 3});
  NEAR(ray.direction, {0, 0, -1}, 1e-5);
}

EXAMPLE("the middle of the right edge") {}

EXAMPLE("two different fields of view") {}

EXAMPLE("a camera that is turned to look along x") {}
