#include "pt/tasks/hit_box.h"

#include <algorithm>

namespace pt {

std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  const double half = 5e-7 * max_abs(box.extent());
  double enter = ray.t_min, leave = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis], d = ray.direction[axis];
    const bool thin = box.extent()[axis] < 2 * half;
    const double low = thin ? box.min[axis] - half : box.min[axis];
    const double high = thin ? box.max[axis] + half : box.max[axis];
    if (d == 0) {
      if (!(o >= low && o <= high)) return std::nullopt;
      continue;
    }
    const double t0 = (low - o) / d, t1 = (high - o) / d;
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1) * (1 + 1e-15));
  }
  if (!(enter <= leave)) return std::nullopt;
  return Interval{enter, leave};
}

}  // namespace pt
