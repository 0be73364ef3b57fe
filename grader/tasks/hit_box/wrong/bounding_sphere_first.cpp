// breaks: works_at_every_scale
// Rejects by the sphere around the box, with squares that lose all digits at a great distance.
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
  const Vec3 to_center = box.center() - ray.origin;
  const double radius_squared = 0.25 * length_squared(box.extent()) * (1 + 1e-9);
  const double b = dot(to_center, ray.direction);
  const double c = length_squared(to_center) - radius_squared;
  if (b * b < length_squared(ray.direction) * c) return std::nullopt;
  return slabs(box, ray);
}

}  // namespace pt
