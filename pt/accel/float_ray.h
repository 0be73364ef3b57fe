// The ray in the form that the single-precision tests of traverse.h need. Internal like simd.h.
#pragma once

#include "pt/accel/simd.h"
#include "pt/accel/wide_tree.h"
#include "pt/geometry/ray.h"

#include <cstddef>
#include <cstdint>

namespace pt {
namespace {

// Error bounds. Let u = 2^-24, and all lengths be those of the tree's frame, in which boxes and
// corners lie in [-1, 1]. Let D be the direction's largest component, and C = 1 + |o| with |o| the
// largest component of the origin, so that no corner is farther than C from it, and t <= 2 C / D.
//
//   A slab plane's distance, (b - o) / d: b is off by u, o by u |o|, 1/d by 3 u of itself, and the
//   products and sums round by u each; together at most 8 u C / d. kSlab doubles that.
//   The normal, n = e1 x e2, of six products a b: each factor is off by u of itself, the product
//   rounds by u, and the difference by u of n. With M and N as in WideBlock::area, the components of
//   n are off by 3 u M together, beside the u of their own, which the following includes.
//   An edge's volume, (d x c) . e with c = p0 - o off by 2 u C: at most 18 u C D E with E as in
//   WideBlock::size; the third, det - U - V, 42 u C D E + 10 u D E^2, as M is at most E^2: together
//   at most 42 u C D size.
//   The plane's, T = n . c, against t det: 6 u C N and 22 u C N, also where det is so small that its
//   sign is wrong; for a bound on t that was itself rounded by 4 u t + u C / D another 18 u C N; and
//   9 u C M, since c is at most C and t D at most 2 C. kVolume covers these, as 46 N + 9 M is less than
//   50 (N + M / 4).
//
// The margin left in both constants (a sixteenth at least) exceeds all terms of higher order, and
// the 16 rounding errors in double by which exact_hit may move a corner. Far away these are no
// longer small against u C; `reach`, which stands for C, grows for them.
constexpr float kUnit = 0x1p-24f;
constexpr float kSlab = 16 * kUnit;
constexpr float kVolume = 50 * kUnit;

// The limits of rays that need no special preparation. Origins are up to kNear away; farther
// origins move along the ray to where the tree begins. The largest component of a direction is
// between kShort and kLong; other directions are scaled. A component below kFlat does not leave its
// plane within reach, so kFlat replaces it: then nothing is infinite. All t are below kMaxT.
constexpr float kNear = 6;
constexpr float kShort = 0x1p-40f;
constexpr float kLong = 0x1p40f;
constexpr float kFlat = 0x1p-100f;
constexpr float kMaxT = 0x1p60f;

typedef double Doubles4 __attribute__((vector_size(32)));
using Floats4 = Floats<4>;
using Ints4 = Ints<4>;

PT_INLINE double larger(double a, double b) { return a > b ? a : b; }
PT_INLINE double smaller(double a, double b) {
#if defined(__SSE2__)
  return _mm_cvtsd_f64(_mm_min_sd(_mm_set_sd(a), _mm_set_sd(b)));  // never a branch
#else
  return a < b ? a : b;
#endif
}

// Arrays hold x, y, z and padding. A test loads each number from memory into all lanes.
struct alignas(16) FloatRay {
  float origin[4];
  float direction[4];
  float inverse[4];
  float enter[4];         // b inverse + enter: no later than the ray crosses the plane b
  float leave[4];         // and no earlier
  std::int32_t first[4];  // per axis, the row of a node's bounds that the ray meets first
  std::int32_t last[4];
  float t_min;
  float t_max;
  float reach;
  float longest;      // D
  float edge_error;   // kVolume reach D
  float plane_error;  // kVolume reach
  float t_slack;      // u C / D where t was shifted
  double t_scale;     // t here = t of the ray * t_scale - t_shift, in double
  double t_shift;
  std::uint32_t source_triangle;  // the source triangle, which need not be tested
  bool is_usual;                  // prepared without further thought

  // A bound of t from above, rounded by no more than kVolume allows for.
  float upper(double t) const { return here(t) * (1 + 4 * kUnit) + t_slack; }

 private:
  float here(double t) const { return static_cast<float>(smaller(t * t_scale - t_shift, kMaxT)); }
};

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

// One at a time: a processor waits for what was just stored in pieces if it loads it as a whole.
PT_INLINE Doubles4 load3(const double* p) {
#if defined(__AVX__)
  const double* y = p + 1;
  __asm__("" : "+r"(y));  // or g++ loads x and y as a whole
  const __m128d xy = _mm_loadh_pd(_mm_load_sd(p), y);
  return (Doubles4)_mm256_insertf128_pd(_mm256_castpd128_pd256(xy), _mm_load_sd(p + 2), 1);
#else
  Doubles4 a;  // the fourth lane is whatever follows
  __builtin_memcpy(&a, p, sizeof a);
  return a;
#endif
}
PT_INLINE double largest(Doubles4 a) {
  typedef std::int64_t Longs4 __attribute__((vector_size(32)));
  a = (Doubles4)((Longs4)a & std::int64_t(0x7fffffffffffffff));
  return larger(larger(a[0], a[1]), a[2]);
}
PT_INLINE float largest(Floats4 a) { return max<4>(max<4>(a, splat<4>(a[1])), splat<4>(a[2]))[0]; }

// Any ray: the direction is scaled until its largest component is in [1, 2), the origin moved along
// the ray to where the tree begins. False where nothing can be met.
static bool prepare_any(const WideView& view, const Ray& ray, FloatRay& r) {
  Doubles4 o = load3(&ray.origin.x), d = load3(&ray.direction.x);
  // NaN times zero is not zero, and neither is infinity.
  const Doubles4 zero = (o + d) * 0.0;
  const double longest = largest(d);
  if (!(zero[0] + zero[1] + zero[2] == 0 && longest > 0 && ray.t_min <= ray.t_max)) return false;
  const std::uint64_t exponent = exponent_of(longest);
  o = (o - load3(view.center)) * view.scale;
  d = d * power_of_two(2046 - exponent);
  r.t_scale = power_of_two(exponent) * view.scale;
  double begin = ray.t_min * r.t_scale, end = ray.t_max * r.t_scale;
  // To half a unit beyond the boxes, or more where double precision is that coarse.
  const double size = largest(o);
  const double side = 1.5 + size * 0x1p-44;
  for (int axis = 0; axis < 3; ++axis) clip(o[axis], d[axis], side, begin, end);
  if (!(begin <= end)) return false;
  o = o + begin * d;
  store<4>(r.origin, __builtin_convertvector(o, Floats4));
  store<4>(r.direction, __builtin_convertvector(d, Floats4));
  r.reach = static_cast<float>(1.0001 + largest(o) + size * 0x1p-20);
  r.t_shift = begin;
  r.t_slack = r.reach * kUnit;
  r.t_min = 0;
  r.t_max = r.upper(ray.t_max);
  return true;
}

// Sets what depends on the direction, once the rest of r is known.
PT_INLINE void set_direction(const WideView& view, FloatRay& r, Floats4 direction, Floats4 length) {
  r.longest = largest(length);
  r.edge_error = r.plane_error * r.longest;
  store<4>(r.direction, direction);
  if (view.root & kLeaf) return;  // there are no boxes
  const Floats4 origin = load<4>(r.origin);
  const Floats4 abs_inverse = 1 / max<4>(length, splat<4>(kFlat));
  const Floats4 inverse = flip<4>(abs_inverse, sign_of<4>(direction));
  const Floats4 slack = (kSlab * r.reach) * abs_inverse;
  store<4>(r.inverse, inverse);
  store<4>(r.enter, multiply_add<4>(-origin, inverse, -slack));
  store<4>(r.leave, multiply_add<4>(-origin, inverse, slack));
  const Ints4 rows{0, 1, 2, 0}, down = ((Ints4)direction >> 31) & 3;
  store<4>(r.first, rows + down);
  store<4>(r.last, rows + (3 - down));
}

// Returns whether a direction is of usual length, from the sizes of its components.
PT_INLINE bool is_usual(Floats4 length) {
  const std::uint32_t not_too_long = less_equal<4>(length, splat<4>(kLong)) & 7;
  const std::uint32_t long_enough = less_equal<4>(splat<4>(kShort), length) & 7;
  return (not_too_long == 7) & (long_enough != 0);
}

PT_INLINE bool prepare(const WideView& view, const Ray& ray, FloatRay& r) {
  static_assert(offsetof(Ray, direction) == 24 && offsetof(Ray, t_min) == 48);
  const Doubles4 o = (load3(&ray.origin.x) - load3(view.center)) * view.scale;
  const Doubles4 d = load3(&ray.direction.x) * view.scale;
  const Floats4 origin = __builtin_convertvector(o, Floats4);
  Floats4 direction = __builtin_convertvector(d, Floats4);
  Floats4 length = magnitude<4>(direction);
  const Floats4 away = magnitude<4>(origin);
  const bool is_near = (less_equal<4>(away, splat<4>(kNear)) & 7) == 7;
  r.is_usual = is_near & is_usual(length) & (ray.t_min >= 0) & (ray.t_min <= ray.t_max);
  if (r.is_usual) {
    r.t_scale = 1;
    r.t_shift = 0;
    r.t_slack = 0;
    r.reach = 1.0001f + largest(away);
    r.t_min = static_cast<float>(smaller(ray.t_min, kMaxT)) * (1 - 4 * kUnit);
    r.t_max = static_cast<float>(smaller(ray.t_max, kMaxT)) * (1 + 4 * kUnit);
    store<4>(r.origin, origin);
  } else {
    if (!prepare_any(view, ray, r)) return false;
    direction = load<4>(r.direction);
    length = magnitude<4>(direction);
  }
  const auto source = static_cast<std::uint32_t>(ray.source_triangle);
  r.source_triangle = source < view.triangle_count ? source : kNothing;
  r.plane_error = kVolume * r.reach;
  set_direction(view, r, direction, length);
  return true;
}

// A ray that differs from one that was prepared, and is usual, in nothing but its direction. It
// leaves out the values that only a query for the nearest hit needs. False where the direction is
// not usual.
PT_INLINE bool prepare_like(const FloatRay& usual, const WideView& view, const Ray& ray,
                            FloatRay& r) {
  const Doubles4 d = load3(&ray.direction.x) * view.scale;
  const Floats4 direction = __builtin_convertvector(d, Floats4);
  const Floats4 length = magnitude<4>(direction);
  store<4>(r.origin, load<4>(usual.origin));
  r.t_min = usual.t_min;
  r.t_max = usual.t_max;
  r.reach = usual.reach;
  r.plane_error = usual.plane_error;
  r.source_triangle = usual.source_triangle;
  set_direction(view, r, direction, length);
  return is_usual(length);
}

}  // namespace
}  // namespace pt
