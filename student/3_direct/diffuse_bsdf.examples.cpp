#include "pt/tasks/diffuse_bsdf.h"

#include "pt/examples/example.h"

using namespace pt;

// Straight up, in the frame whose z axis is the normal.
const Vec3 up{0, 0, 1};

EXAMPLE("a white surface reflects 1 / pi into every direction") {
  NEAR(diffuse_f({1, 1, 1}, up, {0.6, 0, 0.8}), {0.318310, 0.318310, 0.318310}, 1e-5);
}

EXAMPLE("from below nothing is reflected upwards") {}

EXAMPLE("the mean of f cos / pdf is the albedo") {}

EXAMPLE("the density of a direction at 60 degrees") {}
