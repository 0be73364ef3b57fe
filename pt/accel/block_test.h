// Rays against triangles, in single precision: one ray and a block of triangles, or one triangle
// and a group of rays. Internal like simd.h.
#pragma once

#include "pt/accel/float_ray.h"
#include "pt/accel/node_test.h"
#include "pt/accel/simd.h"
#include "pt/accel/wide_tree.h"

namespace pt {
namespace {

using Block = WideBlock<kWidth>;

// The result for W pairs of a ray and a triangle: pairs outside of `maybe` certainly miss, pairs in
// `surely` certainly hit, and the others are decided in double precision. t lies in [(distance -
// error) / det, (distance + error) / det].
template <int W>
struct Verdict {
  std::uint32_t maybe;
  Floats<W> inside;  // by how much, for `surely`: both have to be positive
  Floats<W> in_range;
  Floats<W> edge_error;
  Floats<W> distance;
  Floats<W> det;
  Floats<W> error;

  std::uint32_t surely() const {
    return less_equal<W>(Floats<W>{}, min<W>(inside - edge_error, in_range - error));
  }
};

// W pairs of a ray and a triangle: the vector from the ray's origin to the corner p0, the ray's direction and range, the triangle
// as in WideBlock, and how far the volumes over its edges and t times det may be off.
template <int W>
struct Pairs {
  Lanes3<W> c;
  Lanes3<W> d;
  Floats<W> t_min;
  Floats<W> t_max;
  Lanes3<W> e1;
  Lanes3<W> e2;
  Lanes3<W> n;
  Floats<W> edge_error;
  Floats<W> error;
};

// Moeller and Trumbore 1997 by the normal, undivided, and with the error bounds of
// float_ray.h. U, V and W are the volumes over the three edges. They have the same sign if the ray
// passes between the edges.
template <int W>
PT_INLINE Verdict<W> test_pairs(const Pairs<W>& pairs) {
  const Lanes3<W> r = cross<W>(pairs.d, pairs.c);
  const Floats<W> u = dot<W>(r, pairs.e2);
  const Floats<W> v = dot<W>(r, pairs.e1);
  const Floats<W> det = dot<W>(pairs.d, pairs.n);
  const Floats<W> volume = dot<W>(pairs.c, pairs.n);
  const Floats<W> w = det - u - v;

  Verdict<W> verdict;
  verdict.edge_error = pairs.edge_error;
  verdict.error = pairs.error;
  const Floats<W> least = min<W>(min<W>(u, v), w);
  const Floats<W> most = max<W>(max<W>(u, v), w);
  verdict.inside = max<W>(least, -most);
  const Ints<W> sign = sign_of<W>(det);
  verdict.distance = flip<W>(volume, sign);
  verdict.det = flip<W>(det, sign);
  const Floats<W> after = multiply_add<W>(verdict.det, -pairs.t_min, verdict.distance);
  const Floats<W> before = multiply_subtract<W>(verdict.det, pairs.t_max, verdict.distance);
  verdict.in_range = min<W>(after, before);
  verdict.maybe = less_equal<W>(
      Floats<W>{}, min<W>(verdict.inside + verdict.edge_error, verdict.in_range + verdict.error));
  return verdict;
}

PT_INLINE Lanes3<kWidth> rows(const float (&m)[3][kWidth]) {
  return {load<kWidth>(m[0]), load<kWidth>(m[1]), load<kWidth>(m[2])};
}

PT_INLINE Lanes3<kWidth> normals(const Block& b) { return cross<kWidth>(rows(b.e1), rows(b.e2)); }

// Returns whether the ray may reach the plane of any triangle of the block within its range. This
// is half of test_block, and rules out most walls.
PT_INLINE bool may_reach_planes(const Block& b, const FloatRay& r) {
  constexpr int W = kWidth;
  const Lanes3<W> n = normals(b);
  const Floats<W> volume = dot<W>(rows(b.p0) - splat3<W>(r.origin), n);
  const Floats<W> det = dot<W>(splat3<W>(r.direction), n);
  const Ints<W> sign = sign_of<W>(det);
  const Floats<W> distance = flip<W>(volume, sign), size = flip<W>(det, sign);
  const Floats<W> after = multiply_add<W>(size, splat<W>(-r.t_min), distance);
  const Floats<W> before = multiply_subtract<W>(size, splat<W>(r.t_max), distance);
  const Floats<W> error = r.plane_error * load<W>(b.area);
  return (less_equal<W>(Floats<W>{}, min<W>(after, before) + error) &
          not_equal<W>(b.primitive, r.source_triangle)) != 0;
}

// A ray and the triangles of a block.
PT_INLINE Verdict<kWidth> test_block(const Block& b, const FloatRay& r, float t_max) {
  Verdict<kWidth> verdict = test_pairs<kWidth>(
      {rows(b.p0) - splat3<kWidth>(r.origin), splat3<kWidth>(r.direction), splat<kWidth>(r.t_min),
       splat<kWidth>(t_max), rows(b.e1), rows(b.e2), normals(b),
       r.edge_error * load<kWidth>(b.size), r.plane_error * load<kWidth>(b.area)});
  verdict.maybe &= not_equal<kWidth>(b.primitive, r.source_triangle);
  return verdict;
}

}  // namespace
}  // namespace pt
