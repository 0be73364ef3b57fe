// Rays against spheres, in single precision: a ray and the spheres of a block, or a sphere and a
// group of rays. Internal like simd.h.
#pragma once

#include "pt/accel/block_test.h"

namespace pt {
namespace {

// The bounds of float_ray.h once more, for spheres: their centres c and radii r are at most 1. With
// l = c - o off by 2 u C, d x l is off by 18 u C D, and r |d| by 13 u C D; both bound where the ray
// passes: it meets the sphere where h^2 = (r |d|)^2 - |d x l|^2 >= 0, and h^2 as computed is off by
// less than 2 e (r |d| + e), with e = edge_error = 50 u C D. It meets it at
// (l . d -+ h) / |d|^2, where l . d is off by 18 u C D, and |d|^2 by 5 u of itself, which is 32 u C D
// of what it is compared with; 2 e covers both, and what else is rounded.
//
// exact_hit computes one root from the product of both. It has no correct digit if both are zero up
// to rounding: the ray starts on the sphere and touches it there. This pair is never certain.
template <int W>
struct SphereLines {
  Floats<W> along;  // l . d
  Floats<W> squared;
  Floats<W> h_squared;
  Floats<W> slack;
  std::uint32_t possible;  // spheres that the ray's line may meet
};
template <int W>
PT_INLINE SphereLines<W> meet_lines(const Lanes3<W>& l, Floats<W> radius, const Lanes3<W>& d,
                                    Floats<W> edge_error, Floats<W> longest) {
  const Floats<W> squared = dot<W>(d, d);
  const Lanes3<W> across = cross<W>(d, l);
  const Floats<W> h_squared =
      multiply_subtract<W>(radius * radius, squared, dot<W>(across, across));
  // |d| is at most the square root of three times its largest component.
  const Floats<W> slack = 2 * edge_error * multiply_add<W>(radius, 1.75f * longest, edge_error);
  return {dot<W>(l, d), squared, h_squared, slack, less_equal<W>(Floats<W>{}, h_squared + slack)};
}

template <int W>
PT_INLINE Verdict<W> test_spheres(const Lanes3<W>& l, Floats<W> radius, const Lanes3<W>& d,
                                  Floats<W> edge_error, Floats<W> longest, Floats<W> t_min,
                                  Floats<W> t_max) {
  const SphereLines<W> lines = meet_lines<W>(l, radius, d, edge_error, longest);
  Verdict<W> verdict;
  verdict.maybe = lines.possible;
  if (lines.possible == 0) return verdict;
  const Floats<W> zero{}, along = lines.along, squared = lines.squared;
  const Floats<W> h_squared = lines.h_squared, slack = lines.slack;
  const Floats<W> most = square_root<W>(max<W>(h_squared + slack, zero));
  const Floats<W> least = square_root<W>(max<W>(h_squared - slack, zero));
  const Floats<W> half_chord = 0.5f * (most + least);

  verdict.det = squared;
  verdict.error = 2 * edge_error + 0.5f * (most - least);
  const Floats<W> near = along - half_chord, far = along + half_chord;
  const Floats<W> begin = t_min * squared, end = t_max * squared;
  // The first root, unless it is certainly before the range.
  verdict.distance = choose<W>(less_equal<W>(near + verdict.error, begin), far, near);
  verdict.in_range = min<W>(verdict.distance - begin, end - verdict.distance);
  const std::uint32_t uncertain = less_equal<W>(magnitude<W>(along) + least, 2 * edge_error);
  verdict.inside = choose<W>(uncertain, splat<W>(-1), h_squared - slack);
  verdict.edge_error = zero;
  verdict.maybe &= uncertain | less_equal<W>(zero, verdict.in_range + verdict.error);
  return verdict;
}

// Spheres of a block are tested four at a time.
constexpr int kSphereLanes = 4;

PT_INLINE bool is_sphere(const Block& b, int slot) { return b.size[slot] == kSphere; }

// The spheres among the four slots from `first` on.
PT_INLINE std::uint32_t sphere_slots(const Block& b, int first) {
  return less_equal<kSphereLanes>(load<kSphereLanes>(b.size + first), splat<kSphereLanes>(kSphere));
}
PT_INLINE Lanes3<kSphereLanes> sphere_centers(const Block& b, int first) {
  constexpr int W = kSphereLanes;
  return {load<W>(b.p0[0] + first), load<W>(b.p0[1] + first), load<W>(b.p0[2] + first)};
}

// The spheres among them that the ray's line may meet.
PT_INLINE std::uint32_t possible_spheres(const Block& b, int first, const FloatRay& r) {
  constexpr int W = kSphereLanes;
  return sphere_slots(b, first) & meet_lines<W>(sphere_centers(b, first) - splat3<W>(r.origin),
                                                load<W>(b.e1[0] + first), splat3<W>(r.direction),
                                                splat<W>(r.edge_error), splat<W>(r.longest))
                                      .possible;
}

// Tests a ray against these spheres.
PT_INLINE Verdict<kSphereLanes> test_spheres(const Block& b, int first, const FloatRay& r,
                                             float t_max) {
  constexpr int W = kSphereLanes;
  Verdict<W> verdict =
      test_spheres<W>(sphere_centers(b, first) - splat3<W>(r.origin), load<W>(b.e1[0] + first),
                      splat3<W>(r.direction), splat<W>(r.edge_error), splat<W>(r.longest),
                      splat<W>(r.t_min), splat<W>(t_max));
  verdict.maybe &= sphere_slots(b, first);
  return verdict;
}

}  // namespace
}  // namespace pt
