#include "writeup/estimate.h"

#include <algorithm>
#include <cmath>

namespace writeup {

namespace {

constexpr double kStart = 0.1;  // to start the program and read the scene
constexpr double kSecondsPerRay = 1.6e-7;
constexpr double kTreeSecondsPerRay = 4e-7;
constexpr double kHits = 0.75;          // the part of path rays that hit a surface
constexpr double kAdaptiveShare = 0.4;  // the part of the allowed samples

// Rays per camera sample: the camera ray, and for each bounce a path ray and its shadow rays.
double rays_per_sample(const pt::PathSettings& path) {
  if (path.show_normals) return 1;
  double rays = 1, survivors = 1;
  for (int bounce = 1; bounce <= path.to && survivors > 0.05; ++bounce) {
    if (bounce >= path.from) rays += survivors * path.light_samples;
    rays += survivors;
    survivors *= kHits * (bounce > 1 ? path.survival : 1);
  }
  return rays;
}

}  // namespace

double estimated_seconds(const measure::Spec& spec) {
  const double share = spec.adaptive ? kAdaptiveShare : 1;
  const double rays = share * spec.samples * spec.pixels() * rays_per_sample(spec.path);
  const bool wide = spec.engine == pt::Engine::wide;
  return kStart + rays * (wide ? kSecondsPerRay : kTreeSecondsPerRay);
}

}  // namespace writeup
