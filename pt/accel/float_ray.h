// The ray as the single-precision tests of traverse.cpp want it. Internal like simd.h.
#pragma once

#include "pt/accel/simd.h"
#include "pt/accel/wide_tree.h"
#include "pt/geometry/ray.h"

#include <cstddef>
#include <cstdint>

namespace pt {
namespace {

// Error bounds. Let u = 2^-24, and all lengths be those of the tree's frame, in which boxes and
// corners lie in [-1, 1] and the direction's largest component is D in [1, 2). Let C = 1 + |o|, the
// largest component of the origin, so that no corner is farther than C from it, and t <= 2 C / D.
//
//   A slab plane's distance, (b - o) / d: b is off by u, o by u |o|, 1/d by 3 u of itself, and the
//   products and sums round by u each; together at most 8 u C / d. kSlab doubles that.
//   An edge's volume, (d x c) . e with c = p0 - o off by 2 u C: at most 18 u C D E with E as in
//   WideBlock::size; the third, det - U - V, 42 u C D E + 7 u D E^2, at most 42 u C D size.
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
constexpr double kFar = 6;  // farther origins are moved along the ray to where the tree begins

typedef double Doubles4 __attribute__((vector_size(32)));
typedef float Floats4 __attribute__((vector_size(16)));
typedef std::int32_t Ints4 __attribute__((vector_size(16)));

// Vectors have x, y and z in their first three lanes.
struct FloatRay {
  Floats4 origin;
  Floats4 direction;
  Floats4 inverse;
  Floats4 enter;  // b inverse + enter: no later than the ray crosses the plane b
  Floats4 leave;  // and no earlier
  float t_min;
  float t_max;
  float reach;
  float volume_error;  // kVolume reach D
  double t_scale;      // t here = t of the ray * t_scale - t_shift, in double
  double t_shift;

  // Bounds of a range of t: rounded outwards, by no more than kVolume allows for.
  float lower(double t) const {
    if (t == 0 && t_shift == 0) return 0;
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

// The bits of the exponent of a > 0, and the power of two with such an exponent.
PT_INLINE std::uint64_t exponent_of(double a) { return __builtin_bit_cast(std::uint64_t, a) >> 52; }
PT_INLINE double power_of_two(std::uint64_t exponent) {
  return __builtin_bit_cast(double, exponent << 52);
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
static bool move_to_tree(Doubles4& o, const Doubles4& d, double& begin, double& end) {
  // Half a unit beyond the boxes, or more where double precision is that coarse.
  const double size =
      larger(larger(__builtin_fabs(o[0]), __builtin_fabs(o[1])), __builtin_fabs(o[2]));
  const double side = 1.5 + size * 0x1p-44;
  for (int axis = 0; axis < 3; ++axis) clip(o[axis], d[axis], side, begin, end);
  if (!(begin <= end)) return false;
  o = o + begin * d;
  return true;
}

PT_INLINE Doubles4 load3(const double* p) {
  Doubles4 a;  // the fourth lane is whatever follows
  __builtin_memcpy(&a, p, sizeof a);
  return a;
}
PT_INLINE double largest(Doubles4 a) {
  typedef std::int64_t Longs4 __attribute__((vector_size(32)));
  a = (Doubles4)((Longs4)a & std::int64_t(0x7fffffffffffffff));
  return larger(larger(a[0], a[1]), a[2]);
}

PT_INLINE bool prepare(const WideView& view, const Ray& ray, FloatRay& r) {
  static_assert(offsetof(Ray, direction) == 24 && sizeof(Ray) == 64);
  Doubles4 o = load3(&ray.origin.x), d = load3(&ray.direction.x);
  // NaN times zero is not zero, and neither is infinity.
  const Doubles4 zero = (o + d) * 0.0;
  const double longest = largest(d);
  if (!(zero[0] + zero[1] + zero[2] == 0 && longest > 0 && ray.t_min <= ray.t_max)) return false;
  const std::uint64_t exponent = exponent_of(longest);
  const double unit = power_of_two(2046 - exponent);  // brings `longest` into [1, 2)
  o = (o - load3(view.center)) * view.scale;
  d = d * unit;
  const double size = largest(o);
  r.t_scale = power_of_two(exponent) * view.scale;
  r.t_shift = 0;
  double near_size = size;
  if (!(size <= kFar && ray.t_min >= 0)) {
    double begin = ray.t_min * r.t_scale, end = ray.t_max * r.t_scale;
    if (!move_to_tree(o, d, begin, end)) return false;
    r.t_shift = begin;
    near_size = largest(o);
  }
  r.reach = static_cast<float>(1.0001 + near_size + size * 0x1p-20);
  r.volume_error = kVolume * r.reach * static_cast<float>(longest * unit);
  r.t_min = r.t_shift == 0 ? r.lower(ray.t_min) : 0;
  r.t_max = r.upper(ray.t_max);
  r.origin = __builtin_convertvector(o, Floats4);
  r.direction = __builtin_convertvector(d, Floats4);
  // A component so small that the ray does not leave the plane within reach may as well be a little
  // larger: then nothing is infinite.
  const Ints4 sign = (Ints4)r.direction & std::int32_t(0x80000000);
  const Floats4 length = (Floats4)((Ints4)r.direction ^ sign);
  const Floats4 small = 0x1p-60f - Floats4{};
  const Floats4 abs_inverse = 1 / (length > small ? length : small);
  r.inverse = (Floats4)((Ints4)abs_inverse | sign);
  const Floats4 slack = kSlab * r.reach * abs_inverse;
  const Floats4 at = -(r.origin * r.inverse);
  r.enter = at - slack;
  r.leave = at + slack;
  return true;
}

}  // namespace
}  // namespace pt
