#include "pt/tasks/hit_box.h"

#include <algorithm>
#include <cmath>

namespace pt {

namespace {

std::optional<Interval> slabs(const Box& box, const Ray& ray) {
  double enter = ray.t_min, leave = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0) {
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

}  // namespace

std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  const auto inside = slabs(box, ray);
  if (!inside) return std::nullopt;
  const double tolerance = 1e-9 * length(box.extent());
  const Vec3 p = ray.at(inside->min);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(p[axis] >= box.min[axis] - tolerance)) return std::nullopt;
    if (!(p[axis] <= box.max[axis] + tolerance)) return std::nullopt;
  }
  return inside;
}

}  // namespace pt
