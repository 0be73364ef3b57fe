// Tests whether anything is in the way of one ray. Internal like simd.h.
#pragma once

#include "pt/accel/block_test.h"
#include "pt/accel/decide.h"
#include "pt/accel/node_test.h"
#include "pt/accel/push_children.h"
#include "pt/accel/sphere_test.h"

namespace pt {
namespace {

// Triangles and spheres that are hit for certain need no decision.
template <int W>
PT_INLINE bool is_any_hit(const WideQuery& query, const Ray& ray, const Verdict<W>& verdict,
                          const std::uint32_t* primitives) {
  const std::uint32_t surely = verdict.maybe & verdict.surely();
  if (__builtin_expect(surely == verdict.maybe, 1)) return surely != 0;
  if (surely != 0) return true;
  for (std::uint32_t mask = verdict.maybe; mask != 0; mask &= mask - 1) {
    if (decide(query, ray, primitives[__builtin_ctz(mask)]).hit) return true;
  }
  return false;
}

// kWalls: most triangles are of walls that the ray does not reach.
template <bool kSpheres, bool kWalls = false>
PT_INLINE bool is_blocked(const WideQuery& query, const Ray& ray, const FloatRay& r,
                          const Block& block) {
  for (int i = 0; kSpheres && i < kWidth && is_sphere(block, i); i += kSphereLanes) {
    const Verdict<kSphereLanes> spheres = test_spheres(block, i, r, r.t_max);
    if (is_any_hit(query, ray, spheres, block.primitive + i)) return true;
  }
  if (kWalls && !may_reach_planes(block, r)) return false;
  return is_any_hit(query, ray, test_block(block, r, r.t_max), block.primitive);
}

// The children of a node are visited in any order.
template <bool kSpheres>
PT_INLINE bool search_any(const WideQuery& query, const Ray& ray, const FloatRay& r) {
  const Node* nodes = static_cast<const Node*>(query.view.nodes);
  const Block* blocks = static_cast<const Block*>(query.view.blocks);
  WideRef stack[kStack];
  int size = 0;
  WideRef ref = query.view.root;
  for (;;) {
    if (!(ref & kLeaf)) {
      const Node& node = nodes[ref];
      const std::uint32_t mask = enter_children(node, r, r.t_max).mask;
      if (mask != 0) {
        ref = node.child[__builtin_ctz(mask)];
        size += push_others(node, mask & (mask - 1), stack + size);
        continue;
      }
    } else if (is_blocked<kSpheres>(query, ray, r, blocks[ref & ~kLeaf])) {
      return true;
    }
    if (size == 0) return false;
    ref = stack[--size];
  }
}

// Traces the ray through a scene of one block, a tree with spheres, or a tree without spheres.
PT_INLINE bool trace_any(const WideQuery& query, const Ray& ray, const FloatRay& r) {
  const WideView& view = query.view;
  if (view.root & kLeaf) {
    const Block& block = static_cast<const Block*>(view.blocks)[view.root & ~kLeaf];
    return is_blocked<true, true>(query, ray, r, block);
  }
  return view.has_spheres ? search_any<true>(query, ray, r) : search_any<false>(query, ray, r);
}

PT_INLINE bool any_hit(const WideQuery& query, const Ray& ray) {
  const WideView& view = query.view;
  for (std::uint32_t k = 0; k < view.beside_count; ++k) {
    if (decide(query, ray, view.beside[k]).hit) return true;
  }
  FloatRay r;
  return view.root != kNothing && prepare(view, ray, r) && trace_any(query, ray, r);
}

}  // namespace
}  // namespace pt
