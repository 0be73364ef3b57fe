#include "pt/tasks/hit_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pt {

std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  const double ix = 1 / ray.direction.x, iy = 1 / ray.direction.y, iz = 1 / ray.direction.z;
  const double x0 = (box.min.x - ray.origin.x) * ix, x1 = (box.max.x - ray.origin.x) * ix;
  const double y0 = (box.min.y - ray.origin.y) * iy, y1 = (box.max.y - ray.origin.y) * iy;
  const double z0 = (box.min.z - ray.origin.z) * iz, z1 = (box.max.z - ray.origin.z) * iz;
  const double enter = std::max({std::min(x0, x1), std::min(y0, y1), std::min(z0, z1), ray.t_min});
  const double leave = std::min({std::max(x0, x1), std::max(y0, y1), std::max(x0, z1), ray.t_max});
  if (!(enter <= leave)) return std::nullopt;
  return Interval{enter, leave};
}

}  // namespace pt
