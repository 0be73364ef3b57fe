// The ray as the single-precision tests of traverse.cpp want it. Internal like simd.h.
#pragma once

#include "pt/accel/simd.h"
#include "pt/accel/wide_tree.h"
#include "pt/geometry/ray.h"

namespace pt {
namespace {

// Error bounds. Let u = 2^-24, and all lengths be those of the tree's frame, in which boxes and
// corners lie in [-1, 1] and the direction's largest component is 1. Let C = 1 + |o|, the largest
// component of the origin, so that no corner is farther than C from it, and hits have t <= 2 C.
//
//   A slab plane's distance, (b - o) / d: b is off by u, o by u |o|, 1/d by 3 u of itself, and the
//   products and sums round by u each; together at most 8 u C / d. kSlab doubles that.
//   An edge's volume, (d x c) . e with c = p0 - o off by 2 u C: at most 18 u C E with E as in
//   WideBlock::size; the third, det - U - V, 42 u C E + 7 u E^2, which is less than 42 u C size.
//   The plane's, T = n . c, against t det: 6 u C N and 22 u C N with N <= size^2 the length of n,
//   also where det is so small that its sign is wrong; for a bound on t that was itself rounded
//   by 4 u t + u C another 18 u C N. kVolume covers these.
//
// What is left over in both (a sixteenth at least) exceeds all that is not of first order, and the
// 16 rounding errors in double by which exact_hit may move a corner. Far away these are no longer
// small against u C; `reach`, which stands for C, grows for them.
constexpr float kUnit = 0x1p-24f;
constexpr float kSlab = 16 * kUnit;
constexpr float kVolume = 50 * kUnit;
constexpr double kFar = 2;  // farther origins are moved along the ray to where the tree begins

struct FloatRay {
  float origin[3];
  float direction[3];
  float inverse[3];
  float enter[3];  // b inverse + enter: no later than the ray crosses the plane b
  float leave[3];  // and no earlier
  float t_min;
  float t_max;
  float reach;
  float volume_error;  // kVolume reach
  double t_scale;      // t here = t of the ray * t_scale - t_shift, in double
  double t_shift;

  // Bounds of a range of t: rounded outwards, by no more than kVolume allows for.
  float lower(double t) const {
    const float bound = here(t) * (1 - 4 * kUnit) - reach * kUnit;
    return bound > 0 ? bound : 0;
  }
  float upper(double t) const { return here(t) * (1 + 4 * kUnit) + reach * kUnit; }

 private:
  // Nothing is as far as 64 reach.
  float here(double t) const {
    const double t_here = t * t_scale - t_shift;
    return static_cast<float>(t_here < 64 * reach ? t_here : 64 * reach);
  }
};

PT_INLINE double larger(double a, double b) { return a > b ? a : b; }
PT_INLINE double size_of(Vec3 a) {
  return larger(larger(__builtin_fabs(a.x), __builtin_fabs(a.y)), __builtin_fabs(a.z));
}

// Cuts [begin, end] to where o + t d is within `side` of zero; a range that ends before it begins
// where it never is.
PT_INLINE void clip(double o, double d, double side, double& begin, double& end) {
  if (d == 0) {
    if (!(__builtin_fabs(o) <= side)) end = -kInfinity;
    return;
  }
  const double a = (-side - o) / d, b = (side - o) / d;
  const double near = a < b ? a : b, far = a < b ? b : a;
  begin = begin > near ? begin : near;
  end = end < far ? end : far;
}

// What of the ray can meet the tree at all, for origins far from it and ranges that begin behind
// the origin: moves the origin there. False where nothing can.
static bool move_to_tree(Vec3& o, Vec3 d, double& begin, double& end) {
  // Half a unit beyond the boxes, or more where double precision is that coarse.
  const double side = 1.5 + size_of(o) * 0x1p-44;
  double first = begin, last = end;
  clip(o.x, d.x, side, first, last);
  clip(o.y, d.y, side, first, last);
  clip(o.z, d.z, side, first, last);
  if (!(first <= last)) return false;
  o = {o.x + first * d.x, o.y + first * d.y, o.z + first * d.z};
  begin = first;
  return true;
}

PT_INLINE bool prepare(const WideView& view, const Ray& ray, FloatRay& r) {
  const Vec3& from = ray.origin;
  const Vec3& along = ray.direction;
  const double longest = size_of(along);
  // NaN times zero is not zero, and neither is infinity.
  const bool finite = (from.x + from.y + from.z + along.x + along.y + along.z) * 0 == 0;
  if (!(finite && longest > 0 && ray.t_min <= ray.t_max)) return false;
  const double unit = 1 / longest;
  const double s = view.scale;
  Vec3 o = {(from.x - view.center.x) * s, (from.y - view.center.y) * s,
            (from.z - view.center.z) * s};
  const Vec3 d = {along.x * unit, along.y * unit, along.z * unit};
  const double size = size_of(o);
  r.t_scale = longest * s;
  r.t_shift = 0;
  if (!(size <= kFar && ray.t_min >= 0)) {
    double begin = ray.t_min * r.t_scale, end = ray.t_max * r.t_scale;
    if (!move_to_tree(o, d, begin, end)) return false;
    r.t_shift = begin;
  }
  r.reach = static_cast<float>(1.0001 + size_of(o) + size * 0x1p-20);
  r.volume_error = kVolume * r.reach;
  r.t_min = r.t_shift == 0 ? r.lower(ray.t_min) : 0;
  r.t_max = r.upper(ray.t_max);
  const double os[3] = {o.x, o.y, o.z}, ds[3] = {d.x, d.y, d.z};
  for (int a = 0; a < 3; ++a) {
    r.origin[a] = static_cast<float>(os[a]);
    r.direction[a] = static_cast<float>(ds[a]);
    // A component so small that the ray does not leave the plane within reach may as well be a
    // little larger: then nothing is infinite.
    constexpr float kSmall = 0x1p-60f;
    const float size_a = __builtin_fabsf(r.direction[a]);
    r.inverse[a] = 1 / __builtin_copysignf(size_a > kSmall ? size_a : kSmall, r.direction[a]);
    const float slack = kSlab * r.reach * __builtin_fabsf(r.inverse[a]);
    const float at = -(r.origin[a] * r.inverse[a]);
    r.enter[a] = at - slack;
    r.leave[a] = at + slack;
  }
  return true;
}

}  // namespace
}  // namespace pt
