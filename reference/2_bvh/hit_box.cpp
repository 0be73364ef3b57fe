#include "pt/tasks/hit_box.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pt {

// A box is what three slabs have in common, and a ray is inside a slab from one plane to the other.
//
// Along an axis in which the ray does not move, 1 / d is infinite, and the two distances are
// infinities of opposite sign inside the slab and of the same sign beside it: right without a
// special case. Only on the plane itself they are 0 * infinity = NaN, and there std::max(enter,
// NaN) and std::min(leave, NaN) keep their first argument: the plane belongs to the box.
std::optional<Interval> hit_box(const Box& box, const Ray& ray) {
  // Ize 2013, Robust BVH Ray Traversal: each distance has a relative error of at most gamma(3), so
  // with this factor on the far side no box is missed by rounding.
  constexpr double kEpsilon = 0x1p-53;
  constexpr double kGamma3 = 3 * kEpsilon / (1 - 3 * kEpsilon);
  constexpr double kWiden = 1 + 2 * kGamma3;

  double enter = ray.t_min;
  double leave = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1 / ray.direction[axis];
    double t_near = (box.min[axis] - ray.origin[axis]) * inverse;
    double t_far = (box.max[axis] - ray.origin[axis]) * inverse;
    // The sign of 1 / d, not of d: for d = -0 the slab is crossed downwards too.
    if (inverse < 0) std::swap(t_near, t_far);
    enter = std::max(enter, t_near);
    leave = std::min(leave, t_far * kWiden);
  }
  if (!(enter <= leave)) return std::nullopt;
  return Interval{enter, leave};
}

}  // namespace pt
