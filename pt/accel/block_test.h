// One ray against a block of triangles, in single precision. Internal like simd.h.
#pragma once

#include "pt/accel/float_ray.h"
#include "pt/accel/simd.h"
#include "pt/accel/wide_tree.h"

namespace pt {
namespace {

using BlockFloats = Floats<kBlock>;

// Which triangles of a block the ray may meet, and which it meets for certain.
struct Verdict {
  std::uint32_t maybe;
  std::uint32_t surely;
};

// Moeller and Trumbore 1997 with the normal stored, undivided, and with the error bounds of
// float_ray.h. U, V and W are the volumes over the three edges: of one sign where the ray passes
// between them.
PT_INLINE Verdict test_block(const WideBlock& b, const FloatRay& r, float t_max, bool want_surely) {
  const auto at = [](const float* p) __attribute__((always_inline)) { return load<kBlock>(p); };
  const auto all = [](float a) __attribute__((always_inline)) { return splat<kBlock>(a); };
  const BlockFloats dx = all(r.direction[0]), dy = all(r.direction[1]), dz = all(r.direction[2]);
  const BlockFloats cx = at(b.p0[0]) - all(r.origin[0]);
  const BlockFloats cy = at(b.p0[1]) - all(r.origin[1]);
  const BlockFloats cz = at(b.p0[2]) - all(r.origin[2]);
  const BlockFloats rx = multiply_subtract<kBlock>(dy, cz, dz * cy);
  const BlockFloats ry = multiply_subtract<kBlock>(dz, cx, dx * cz);
  const BlockFloats rz = multiply_subtract<kBlock>(dx, cy, dy * cx);
  const auto dot3 = [&](BlockFloats x, BlockFloats y, BlockFloats z, const float(*m)[kBlock])
      __attribute__((always_inline)) {
    return multiply_add<kBlock>(z, at(m[2]), multiply_add<kBlock>(y, at(m[1]), x * at(m[0])));
  };
  const BlockFloats u = dot3(rx, ry, rz, b.e2);
  const BlockFloats v = dot3(rx, ry, rz, b.e1);
  const BlockFloats det = dot3(dx, dy, dz, b.n);
  const BlockFloats volume = dot3(cx, cy, cz, b.n);
  const BlockFloats w = det - u - v;

  const BlockFloats size = at(b.size);
  const BlockFloats edge_error = all(r.volume_error) * size;
  const BlockFloats error = edge_error * size;
  const BlockFloats least = min<kBlock>(min<kBlock>(u, v), w);
  const BlockFloats most = max<kBlock>(max<kBlock>(u, v), w);
  const Ints<kBlock> sign = sign_of<kBlock>(det);
  const BlockFloats turned = flip<kBlock>(volume, sign);
  const BlockFloats abs_det = flip<kBlock>(det, sign);
  const BlockFloats after = turned - abs_det * all(r.t_min);
  const BlockFloats before = abs_det * all(t_max) - turned;

  const BlockFloats inside = min<kBlock>(after, before);
  Verdict verdict{};
  verdict.maybe =
      bits<kBlock>(((-edge_error <= least) | (most <= edge_error)) & (-error <= inside));
  if (!want_surely || verdict.maybe == 0) return verdict;
  verdict.surely =
      bits<kBlock>(((edge_error <= least) | (most <= -edge_error)) & (error <= inside));
  return verdict;
}

}  // namespace
}  // namespace pt
