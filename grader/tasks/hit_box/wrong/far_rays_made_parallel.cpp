// breaks: hits_where_it_is_aimed
// Takes a component below a billionth of the direction for 0, however long the way.
#include "pt/tasks/hit_box.h"

#include <algorithm>
#include <cmath>

namespace pt {

std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  const double least = 1e-9 * length(ray.direction);
  double enter = ray.t_min, leave = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis], d = ray.direction[axis];
    if (std::abs(d) < least) {
      if (!(o >= box.min[axis] && o <= box.max[axis])) return std::nullopt;
      continue;
    }
    const double t0 = (box.min[axis] - o) / d, t1 = (box.max[axis] - o) / d;
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1) * (1 + 1e-15));
  }
  if (!(enter <= leave)) return std::nullopt;
  return Interval{enter, leave};
}

}  // namespace pt
