#include "pt/tasks/direct_lights.h"

#include "pt/examples/example.h"
#include "pt/examples/scenes.h"

using namespace pt;
using namespace pt::scenes;

EXAMPLE("a point light 2 above the floor: the irradiance is 4 pi / 2^2") {
  const Scene scene = floor_under({PointLight{{0, 2, 0}, 4 * kPi * kWhite}});
  Sampler sampler(1);
  NEAR(direct_lights(scene, middle_of_floor(scene), 16, sampler), kBrown);
}

EXAMPLE("a point light below the floor") {}

EXAMPLE("two lights, and something in the way of one of them") {}

EXAMPLE("a square lamp, as a mean") {}
