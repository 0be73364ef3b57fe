#include "pt/tasks/hit_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pt {

std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  Interval all{kInfinity, -kInfinity};
  for (int axis = 0; axis < 3; ++axis) {
    double t0 = (box.min[axis] - ray.origin[axis]) / ray.direction[axis];
    double t1 = (box.max[axis] - ray.origin[axis]) / ray.direction[axis];
    if (t0 > t1) std::swap(t0, t1);
    if (t0 <= ray.t_max && t1 >= ray.t_min) {
      all.min = std::min(all.min, std::max(t0, ray.t_min));
      all.max = std::max(all.max, std::min(t1, ray.t_max));
    }
  }
  if (all.min > all.max) return std::nullopt;
  return all;
}

}  // namespace pt
