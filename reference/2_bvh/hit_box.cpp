#include "pt/tasks/hit_box.h"

#include <algorithm>

namespace pt {

namespace {

// The values of t at which the ray enters and leaves a slab. The test is on 1 / direction: for a
// direction of -0 that is negative, but -0 < 0 is false.
Interval crossings(double plane_min, double plane_max, double origin, double direction) {
  const double inverse = 1 / direction;
  const double to_min = (plane_min - origin) * inverse;
  const double to_max = (plane_max - origin) * inverse;
  return inverse < 0 ? Interval{to_max, to_min} : Interval{to_min, to_max};
}

}  // namespace

// A box is the intersection of three slabs, and a ray is in a slab between the slab's two planes.
//
// Along an axis in which the ray does not move, 1 / d is infinite, and the two crossings are
// infinities: of opposite sign inside the slab, of the same sign beside it. No special case is
// needed. Only if the ray lies in a plane, one crossing is 0 * infinity = NaN. Then std::max(enter,
// NaN) and std::min(leave, NaN) keep their first argument: the planes belong to the box.
std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  // Ize 2013, Robust BVH Ray Traversal: each crossing has a relative error of at most gamma(3), so
  // with this factor on the far planes no box is missed by rounding.
  constexpr double kEpsilon = 0x1p-53;
  constexpr double kGamma3 = 3 * kEpsilon / (1 - 3 * kEpsilon);
  constexpr double kWiden = 1 + 2 * kGamma3;

  const Vec3 o = ray.origin, d = ray.direction;
  const Interval x = crossings(box.min.x, box.max.x, o.x, d.x);
  const Interval y = crossings(box.min.y, box.max.y, o.y, d.y);
  const Interval z = crossings(box.min.z, box.max.z, o.z, d.z);
  const double enter = std::max(std::max(std::max(ray.t_min, x.min), y.min), z.min);
  const double leave =
      std::min(std::min(std::min(ray.t_max, kWiden * x.max), kWiden * y.max), kWiden * z.max);
  if (!(enter <= leave)) return std::nullopt;
  return Interval{enter, leave};
}

}  // namespace pt
