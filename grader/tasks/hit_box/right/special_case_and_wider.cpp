// right: an axis without movement is a case of its own; the interval a few rounding errors wider
#include "pt/tasks/hit_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pt {

std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  constexpr double kWider = 4 * std::numeric_limits<double>::epsilon();
  double enter = ray.t_min, leave = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0) {
      if (o < box.min[axis] || o > box.max[axis]) return std::nullopt;
      continue;
    }
    const double t0 = (box.min[axis] - o) / d, t1 = (box.max[axis] - o) / d;
    const double near = std::min(t0, t1), far = std::max(t0, t1);
    enter = std::max(enter, near - kWider * std::abs(near));
    leave = std::min(leave, far + kWider * std::abs(far));
  }
  if (!(enter <= leave)) return std::nullopt;
  return Interval{enter, leave};
}

}  // namespace pt
