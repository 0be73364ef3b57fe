// breaks: gives_the_right_interval
// Computes in float, and loses half of the digits.
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
    float t0 = static_cast<float>(box.min[axis] - ray.origin[axis]) * static_cast<float>(inverse);
    float t1 = static_cast<float>(box.max[axis] - ray.origin[axis]) * static_cast<float>(inverse);
    if (t0 > t1) std::swap(t0, t1);
    enter = std::max(enter, static_cast<double>(t0));
    leave = std::min(leave, t1 * (1 + 1e-15));
  }
  if (!(enter <= leave)) return std::nullopt;
  return Interval{enter, leave};
}

}  // namespace pt
