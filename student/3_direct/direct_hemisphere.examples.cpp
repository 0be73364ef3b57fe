#include "pt/tasks/direct_hemisphere.h"

#include "pt/examples/example.h"
#include "pt/examples/scenes.h"

using namespace pt;
using namespace pt::scenes;

EXAMPLE("under a white sky a floor reflects its albedo") {
  const Scene scene = floor_under_sky();
  MEAN(300, direct_hemisphere(scene, middle_of_floor(scene), 64, sampler), kBrown, 0.03);
}

EXAMPLE("a wall sees half of the sky") {}

EXAMPLE("no ray meets a point light") {}

EXAMPLE("a square lamp over the floor, and something in the way") {}
