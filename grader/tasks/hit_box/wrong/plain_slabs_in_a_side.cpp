// breaks: takes_rays_in_its_sides_bonus
// The usual slabs: 0 times infinity is NaN, which one of min and max keeps.
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
    enter = std::max(enter, std::min(t1, t0));
    leave = std::min(leave, std::max(t1, t0));
  }
  if (!(enter <= leave)) return std::nullopt;
  return Interval{enter, leave};
}

}  // namespace pt
