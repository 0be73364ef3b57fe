// breaks: never_misses_by_a_rounding_error_bonus
// The usual slabs: right, but two planes that meet in an edge are rounded apart.
#include "pt/tasks/hit_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pt {

std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  double enter = ray.t_min, leave = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1 / ray.direction[axis];
    const double t0 = (box.min[axis] - ray.origin[axis]) * inverse;
    const double t1 = (box.max[axis] - ray.origin[axis]) * inverse;
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  if (!(enter <= leave)) return std::nullopt;
  return Interval{enter, leave};
}

}  // namespace pt
