// right: min and max of the two quotients instead of a swap
#include "pt/tasks/hit_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pt {

std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  double enter = ray.t_min, leave = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double t0 = (box.min[axis] - ray.origin[axis]) / ray.direction[axis];
    const double t1 = (box.max[axis] - ray.origin[axis]) / ray.direction[axis];
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  if (enter <= leave) return Interval{enter, leave};
  return std::nullopt;
}

}  // namespace pt
