#include "pt/tasks/estimate_pixel.h"

#include "pt/examples/example.h"
#include "pt/examples/scenes.h"

using namespace pt;
using namespace pt::scenes;

EXAMPLE("half of pixel (0, 0) is bright") {
  const Scene scene = bright(-1, -0.75, -1, 0);
  MEAN(500, estimate_pixel(view_of(scene), 0, 0, 16, sampler), gray(0.5), 0.04);
}

EXAMPLE("a single sample goes through the centre") {}

EXAMPLE("what is bright beside the pixel adds nothing") {}

EXAMPLE("a quarter of the pixel is a million times as bright") {}
