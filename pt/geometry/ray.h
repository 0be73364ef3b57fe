#pragma once

#include "pt/math/vec3.h"

#include <cstdint>

namespace pt {

// A closed range of ray parameters. It is empty if min > max.
struct Interval {
  double min = 0;
  double max = 0;
};

// The points origin + t direction with t_min <= t <= t_max, in world space; t_min >= 0. If the
// direction has unit length, t is a distance; every interface says whether it needs this. A hit
// whose t lies outside the range is not a hit. A search that shortens its ray works on a copy: the
// caller's ray does not change.
struct Ray {
  Vec3 origin;
  Vec3 direction;
  double t_min = 0;
  double t_max = kInfinity;
  // The triangle that the ray starts on and moves away from, or -1: an engine need not test it. No
  // task has to look at it. It has 64 bits so that the struct does not end in padding: g++ copies a
  // padded struct slowly, which cost a tenth of the time of a picture.
  std::int64_t source_triangle = -1;

  Vec3 at(double t) const { return origin + t * direction; }
};

}  // namespace pt
