// method: slabs, without anything for rounding errors
#include "pt/tasks/hit_box.h"

#include <utility>

#ifndef REAL
#define REAL double
#endif

namespace pt {

std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  double enter = ray.t_min, leave = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const REAL origin = static_cast<REAL>(ray.origin[axis]);
    const REAL inverse = 1 / static_cast<REAL>(ray.direction[axis]);
    REAL a = (static_cast<REAL>(box.min[axis]) - origin) * inverse;
    REAL b = (static_cast<REAL>(box.max[axis]) - origin) * inverse;
    if (inverse < 0) std::swap(a, b);
    enter = a > enter ? a : enter;  // a NaN changes nothing
    leave = b < leave ? b : leave;
  }
  if (!(enter <= leave)) return std::nullopt;
  return Interval{enter, leave};
}

}  // namespace pt
