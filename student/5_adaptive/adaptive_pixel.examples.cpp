#include "pt/tasks/adaptive_pixel.h"

#include "pt/examples/example.h"
#include "pt/examples/scenes.h"

using namespace pt;
using namespace pt::scenes;

EXAMPLE("a constant takes one batch") {
  const Scene scene = bright(-1, 1, -1, 1, kBrown);
  Sampler sampler(1);
  const PixelEstimate estimate = adaptive_pixel(view_of(scene), 0, 0, {1000, 16, 0.05}, sampler);
  EXPECT(estimate.samples == 16);
  NEAR(estimate.mean, kBrown);
}

EXAMPLE("half of the pixel is bright") {}

EXAMPLE("a tolerance that is never reached takes max_samples") {}

EXAMPLE("a dark pixel with noise does not stop early") {}
