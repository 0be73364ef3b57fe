#pragma once

#include "measure/calls/draw.h"
#include "measure/calls/exact.h"
#include "measure/calls/precise.h"

// Rays that are aimed at shapes.

namespace measure::calls {

inline constexpr long double kMargin =
    0.01L;  // of barycentric coordinates and of a radius, to avoid borders

template <class Shape>
struct Aimed {
  Shape shape;
  pt::Ray ray;
  bool hits = false;
};

// A ray towards `target`, with a direction of any length.
inline pt::Ray ray_towards(pt::Vec3 origin, pt::Vec3 target, pt::Sampler& sampler) {
  pt::Ray ray;
  ray.origin = origin;
  ray.direction = size_between(-3, 3, sampler) * normalize(target - origin);
  return ray;
}

}  // namespace measure::calls
