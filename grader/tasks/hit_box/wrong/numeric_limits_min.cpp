#include "pt/tasks/hit_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pt {

std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  double enter = std::numeric_limits<double>::min(), leave = std::numeric_limits<double>::max();
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis], d = ray.direction[axis];
    double t0 = std::numeric_limits<double>::min(), t1 = std::numeric_limits<double>::max();
    if (std::abs(d) > 1e-12) {
      t0 = std::min((box.min[axis] - o) / d, (box.max[axis] - o) / d);
      t1 = std::max((box.min[axis] - o) / d, (box.max[axis] - o) / d);
    }
    enter = std::max(enter, t0);
    leave = std::min(leave, t1);
  }
  enter = std::max(enter, ray.t_min);
  leave = std::min(leave, ray.t_max);
  if (!(enter <= leave)) return std::nullopt;
  return Interval{enter, leave};
}

}  // namespace pt
