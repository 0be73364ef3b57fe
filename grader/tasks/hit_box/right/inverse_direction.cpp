// right: the inverse direction once, all axes in one expression
#include "pt/tasks/hit_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pt {

std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  const Vec3 inverse{1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z};
  const auto times = [&](Vec3 plane) {
    const Vec3 d = plane - ray.origin;
    return Vec3{d.x * inverse.x, d.y * inverse.y, d.z * inverse.z};
  };
  const Vec3 a = times(box.min), b = times(box.max);
  const Vec3 near = min(a, b), far = max(a, b);
  const double enter = std::max({near.x, near.y, near.z, ray.t_min});
  const double leave = std::min({far.x, far.y, far.z, ray.t_max});
  if (!(enter <= leave)) return std::nullopt;
  return Interval{enter, leave};
}

}  // namespace pt
