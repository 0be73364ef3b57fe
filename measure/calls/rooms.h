#pragma once

#include "measure/calls/estimates.h"
#include "pt/scene/scene.h"

#include <memory>
#include <vector>

// Rooms in which the light at some points is known.

namespace measure::calls {

// A point of a surface, and the luminance that leaves it.
struct Place {
  pt::SurfacePoint point;
  double truth = 0;
};

struct Room {
  pt::Scene scene;
  std::vector<Place> places;
};

// The scene with the fast engine as its tracer.
pt::Scene complete(pt::Scene scene);

// The point that the ray from `origin` meets.
Place place(const pt::Scene& scene, pt::Vec3 origin, pt::Vec3 direction);

// Direct light on a floor below two lamps, with 1 sample (case 0) or 16 samples (case 1).
using Direct = pt::Rgb (*)(const pt::Scene&, const pt::SurfacePoint&, int samples, pt::Sampler&);
Subject measure_direct(Direct direct, int of_case);

}  // namespace measure::calls
