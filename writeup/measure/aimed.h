#pragma once

#include "writeup/measure/draw.h"
#include "writeup/measure/exact.h"
#include "writeup/measure/precise.h"

// Rays that are aimed at shapes.

namespace writeup::measure {

inline constexpr long double kMargin =
    0.01L;  // of barycentric coordinates, and of a radius: no borders

template <class Shape>
struct Aimed {
  Shape shape;
  pt::Ray ray;
  bool hits = false;
};

// Towards `target`, its direction of any length.
inline pt::Ray ray_towards(pt::Vec3 origin, pt::Vec3 target, pt::Sampler& sampler) {
  pt::Ray ray;
  ray.origin = origin;
  ray.direction = size_between(-3, 3, sampler) * normalize(target - origin);
  return ray;
}

}  // namespace writeup::measure
