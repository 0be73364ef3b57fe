// One ray against a block of triangles, in single precision. Internal like simd.h.
#pragma once

#include "pt/accel/float_ray.h"
#include "pt/accel/node_test.h"
#include "pt/accel/simd.h"
#include "pt/accel/wide_tree.h"

namespace pt {
namespace {

using Block = WideBlock<kWidth>;
using BlockFloats = Floats<kWidth>;

// What is known of a block's triangles: the ray meets none but those in `maybe`, and for certain
// those in `surely`. t lies in [(distance - error) / det, (distance + error) / det].
struct Verdict {
  std::uint32_t maybe;
  BlockFloats inside;  // by how much, for `surely`: both have to be positive
  BlockFloats in_range;
  BlockFloats edge_error;
  BlockFloats distance;
  BlockFloats det;
  BlockFloats error;

  std::uint32_t surely() const {
    return less_equal<kWidth>(BlockFloats{}, min<kWidth>(inside - edge_error, in_range - error));
  }
};

// Moeller and Trumbore 1997 with the normal stored, undivided, and with the error bounds of
// float_ray.h. U, V and W are the volumes over the three edges: of one sign where the ray passes
// between them.
PT_INLINE Verdict test_block(const Block& b, const FloatRay& r, float t_max) {
  const auto at = [](const float* p) __attribute__((always_inline)) { return load<kWidth>(p); };
  const auto all = [](float a) __attribute__((always_inline)) { return splat<kWidth>(a); };
  const BlockFloats dx = all(r.direction[0]), dy = all(r.direction[1]), dz = all(r.direction[2]);
  const BlockFloats cx = at(b.p0[0]) - all(r.origin[0]);
  const BlockFloats cy = at(b.p0[1]) - all(r.origin[1]);
  const BlockFloats cz = at(b.p0[2]) - all(r.origin[2]);
  const BlockFloats rx = multiply_subtract<kWidth>(dy, cz, dz * cy);
  const BlockFloats ry = multiply_subtract<kWidth>(dz, cx, dx * cz);
  const BlockFloats rz = multiply_subtract<kWidth>(dx, cy, dy * cx);
  const auto dot3 = [&](BlockFloats x, BlockFloats y, BlockFloats z, const float(*m)[kWidth])
      __attribute__((always_inline)) {
    return multiply_add<kWidth>(z, at(m[2]), multiply_add<kWidth>(y, at(m[1]), x * at(m[0])));
  };
  const BlockFloats u = dot3(rx, ry, rz, b.e2);
  const BlockFloats v = dot3(rx, ry, rz, b.e1);
  const BlockFloats det = dot3(dx, dy, dz, b.n);
  const BlockFloats volume = dot3(cx, cy, cz, b.n);
  const BlockFloats w = det - u - v;

  Verdict verdict;
  verdict.edge_error = all(r.edge_error) * at(b.size);
  verdict.error = all(r.plane_error) * at(b.area);
  const BlockFloats least = min<kWidth>(min<kWidth>(u, v), w);
  const BlockFloats most = max<kWidth>(max<kWidth>(u, v), w);
  verdict.inside = max<kWidth>(least, -most);
  const Ints<kWidth> sign = sign_of<kWidth>(det);
  verdict.distance = flip<kWidth>(volume, sign);
  verdict.det = flip<kWidth>(det, sign);
  const BlockFloats after = multiply_add<kWidth>(verdict.det, all(-r.t_min), verdict.distance);
  const BlockFloats before = multiply_subtract<kWidth>(verdict.det, all(t_max), verdict.distance);
  verdict.in_range = min<kWidth>(after, before);
  verdict.maybe = less_equal<kWidth>(BlockFloats{}, min<kWidth>(verdict.inside + verdict.edge_error,
                                                                verdict.in_range + verdict.error));
  verdict.maybe &= not_equal<kWidth>(b.primitive, r.leaves);
  return verdict;
}

}  // namespace
}  // namespace pt
