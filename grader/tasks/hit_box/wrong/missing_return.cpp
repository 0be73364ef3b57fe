#include "pt/tasks/hit_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pt {

namespace {

double larger(double a, double b) {
  if (a >= b) return a;
}

}  // namespace

std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  double enter = ray.t_min, leave = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1 / ray.direction[axis];
    double t0 = (box.min[axis] - ray.origin[axis]) * inverse;
    double t1 = (box.max[axis] - ray.origin[axis]) * inverse;
    if (t0 > t1) std::swap(t0, t1);
    enter = larger(enter, t0);
    leave = std::min(leave, t1 * (1 + 1e-15));
  }
  if (!(enter <= leave)) return std::nullopt;
  return Interval{enter, leave};
}

}  // namespace pt
