// One ray against all children of a node, in single precision. Internal like simd.h.
#pragma once

#include "pt/accel/float_ray.h"
#include "pt/accel/simd.h"
#include "pt/accel/wide_tree.h"

namespace pt {
namespace {

#if defined(__AVX512F__)
constexpr int kWidth = 16;
#else
constexpr int kWidth = 8;
#endif

using Node = WideNode<kWidth>;
using NodeFloats = Floats<kWidth>;

PT_INLINE Ints<kWidth> children(const Node& node) {
  Ints<kWidth> child;
  __builtin_memcpy(&child, node.child, sizeof child);
  return child;
}

// The children whose boxes the ray enters, as bits, and where it enters them.
struct Entered {
  std::uint32_t mask;
  NodeFloats t;
};
PT_INLINE Entered enter_children(const Node& node, const FloatRay& r, float t_max) {
  NodeFloats enter[3], leave[3];
  for (int a = 0; a < 3; ++a) {
    const NodeFloats inverse = splat<kWidth>(r.inverse[a]);
    const NodeFloats near = load<kWidth>(node.bounds[r.first[a]]);
    const NodeFloats far = load<kWidth>(node.bounds[r.last[a]]);
    enter[a] = multiply_add<kWidth>(near, inverse, splat<kWidth>(r.enter[a]));
    leave[a] = multiply_add<kWidth>(far, inverse, splat<kWidth>(r.leave[a]));
  }
  const NodeFloats begin = splat<kWidth>(r.t_min), end = splat<kWidth>(t_max);
  const NodeFloats in = max<kWidth>(max<kWidth>(enter[0], enter[1]), max<kWidth>(enter[2], begin));
  const NodeFloats out = min<kWidth>(min<kWidth>(leave[0], leave[1]), min<kWidth>(leave[2], end));
  return {less_equal<kWidth>(in, out), in};
}

}  // namespace
}  // namespace pt
