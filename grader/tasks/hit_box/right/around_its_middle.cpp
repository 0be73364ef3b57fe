// right: the slab as a middle and half a width, widened by some rounding errors
#include "pt/tasks/hit_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pt {

// The middle of a slab is met at t, and its planes at t - dt and t + dt.
std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  const Vec3 half = 0.5 * box.extent(), to_middle = box.center() - ray.origin;
  Interval inside{ray.t_min, ray.t_max};
  for (const int axis : {2, 0, 1}) {
    const double d = std::abs(ray.direction[axis]);
    const double sign = std::signbit(ray.direction[axis]) ? -1 : 1;
    const double way = sign * to_middle[axis];
    const double size =
        std::max(std::abs(box.min[axis]), std::abs(box.max[axis])) + std::abs(ray.origin[axis]);
    const double reach = half[axis] + 4 * std::numeric_limits<double>::epsilon() * size;
    if (d == 0) {
      if (std::abs(way) > reach) return std::nullopt;
      continue;
    }
    inside.min = std::max(inside.min, (way - reach) / d);
    inside.max = std::min(inside.max, (way + reach) / d);
  }
  if (inside.min <= inside.max) return inside;
  return std::nullopt;
}

}  // namespace pt
