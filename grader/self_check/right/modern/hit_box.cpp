#include "pt/tasks/hit_box.h"

#include <algorithm>
namespace pt {
std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  double lo = ray.t_min, hi = ray.t_max;
  for (int a = 0; a < 3; ++a) {
    const double o = ray.origin[a], d = ray.direction[a];
    if (d == 0) {
      if (o < box.min[a] || o > box.max[a]) return std::nullopt;
      continue;
    }
    const double a1 = (box.min[a] - o) / d, a2 = (box.max[a] - o) / d;
    const double near = std::min(a1, a2), far = std::max(a1, a2);
    lo = std::max(lo, near);
    hi = std::min(hi, far * (1 + 4e-16));
  }
  if (lo <= hi) return Interval{lo, hi};
  return std::nullopt;
}
}  // namespace pt
