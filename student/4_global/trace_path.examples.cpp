#include "pt/tasks/trace_path.h"

#include "pt/examples/example.h"
#include "pt/examples/scenes.h"

using namespace pt;
using namespace pt::scenes;

EXAMPLE("two bounces in a ball of albedo 1/2: 1/2 + 1/4") {
  const Scene scene = ball_with_point_light(gray(0.5));
  const SurfacePoint point = seen(scene, {0.1, 0, 0}, {0.3, -1, 0.2});
  PathSettings settings;  // by light sampling
  settings.to = 2;
  MEAN(1000, trace_path(scene, point, settings, sampler), gray(0.75), 0.05);
}

EXAMPLE("the second bounce alone") {}

EXAMPLE("a path that leaves the scene keeps the light that it found") {}

EXAMPLE("three bounces in a furnace") {}
