// right: both ends pushed outwards by some units in the last place
#include "pt/tasks/hit_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pt {

namespace {

double pushed(double t, double towards) {
  for (int i = 0; i < 4; ++i) t = std::nextafter(t, towards);
  return t;
}

}  // namespace

std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  double enter = ray.t_min, leave = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis];
    if (d == 0) {
      if (ray.origin[axis] < box.min[axis] || ray.origin[axis] > box.max[axis]) return {};
      continue;
    }
    const auto [near, far] = std::minmax(
        {(box.min[axis] - ray.origin[axis]) / d, (box.max[axis] - ray.origin[axis]) / d});
    enter = std::max(enter, pushed(near, -kInfinite));
    leave = std::min(leave, pushed(far, kInfinite));
  }
  if (enter > leave) return {};
  return Interval{enter, leave};
}

}  // namespace pt
