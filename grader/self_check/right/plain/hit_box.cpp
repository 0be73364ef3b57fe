#include "pt/tasks/hit_box.h"

#include <algorithm>
namespace pt {
std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  double t0 = ray.t_min, t1 = ray.t_max;
  for (int a = 0; a < 3; a++) {
    double inv = 1.0 / ray.direction[a];
    double tn = (box.min[a] - ray.origin[a]) * inv;
    double tf = (box.max[a] - ray.origin[a]) * inv;
    if (tn > tf) std::swap(tn, tf);
    t0 = tn > t0 ? tn : t0;
    t1 = tf < t1 ? tf : t1;
    if (t0 > t1) return std::nullopt;
  }
  return Interval{t0, t1};
}
}  // namespace pt
