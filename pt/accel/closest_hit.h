// The nearest hit of one ray. Internal like simd.h.
#pragma once

#include "pt/accel/block_test.h"
#include "pt/accel/decide.h"
#include "pt/accel/kernel.h"
#include "pt/accel/node_test.h"
#include "pt/accel/push_children.h"
#include "pt/accel/sphere_test.h"

namespace pt {
namespace {

// Keeps the nearer hit. Among hits at the same t, it keeps the primitive with the smallest index.
PT_INLINE bool offer(const ExactHit& hit, std::uint32_t primitive, WideHit& best) {
  if (!hit.hit || hit.t > best.hit.t || (hit.t == best.hit.t && primitive > best.primitive)) {
    return false;
  }
  best = {hit, primitive};
  return true;
}

// The nearest hit so far: `best` has been decided; `sure` is a triangle that is hit for certain,
// somewhere between t_low and t_max, and nearer than `best`. Most rays decide only one triangle,
// the last.
struct Nearest {
  WideHit best{{false, kInfinity, 0, 0, 0}, kNothing};
  std::uint32_t sure = kNothing;
  float t_low = 0;
  float t_max = 0;
};

PT_INLINE void settle(const WideQuery& query, const Ray& ray, Nearest& nearest) {
  if (nearest.sure == kNothing) return;
  offer(exact::meet(query.triangles[nearest.sure], ray), nearest.sure, nearest.best);
  nearest.sure = kNothing;
}

PT_INLINE void ask(const WideQuery& query, const Ray& ray, const FloatRay& r,
                   std::uint32_t primitive, Nearest& nearest) {
  if (!offer(decide(query, ray, primitive), primitive, nearest.best)) return;
  const float t = r.upper(nearest.best.hit.t);
  nearest.t_max = t < nearest.t_max ? t : nearest.t_max;
}

// Tests the triangles of a block and updates the nearest hit. kEnds: no block follows, so that a
// single certain hit need not be compared with others.
template <bool kEnds>
PT_INLINE void meet_triangles(const WideQuery& query, const Ray& ray, const FloatRay& r,
                              const Block& block, Nearest& nearest) {
  constexpr int W = kWidth;
  const std::uint32_t* primitives = block.primitive;
  const Verdict<W> verdict = test_block(block, r, nearest.t_max);
  if (verdict.maybe == 0) return;
  const std::uint32_t surely = verdict.surely();
  const bool is_one = (verdict.maybe & (verdict.maybe - 1)) == 0;
  if (kEnds && is_one && (surely & verdict.maybe) != 0 && nearest.sure == kNothing) {
    nearest.sure = primitives[__builtin_ctz(verdict.maybe)];
    return;
  }
  alignas(64) float low[W], high[W];
  const Floats<W> inverse = 1 / verdict.det;
  store<W>(low, (verdict.distance - verdict.error) * inverse);
  store<W>(high, (verdict.distance + verdict.error) * inverse);
  for (std::uint32_t mask = verdict.maybe; mask != 0; mask &= mask - 1) {
    const int i = __builtin_ctz(mask);
    if (!(surely >> i & 1)) {
      ask(query, ray, r, primitives[i], nearest);
      continue;
    }
    const float t_low = low[i] * (1 - 8 * kUnit), t_high = high[i] * (1 + 8 * kUnit);
    if (t_low > nearest.t_max) continue;
    if (nearest.sure != kNothing && !(t_high < nearest.t_low)) {
      // The errors are too large to say which is nearer.
      settle(query, ray, nearest);
      ask(query, ray, r, primitives[i], nearest);
      continue;
    }
    nearest.sure = primitives[i];
    const auto* corners = reinterpret_cast<const char*>(query.triangles + nearest.sure);
    for (std::size_t at = 0; at < sizeof(Triangle); at += 64) __builtin_prefetch(corners + at);
    nearest.t_low = t_low;
    nearest.t_max = t_high < nearest.t_max ? t_high : nearest.t_max;
  }
}

// Spheres that may be hit are decided in double precision at once. This is as fast as computing the
// hit in single precision.
template <bool kSpheres, bool kEnds>
PT_INLINE void meet_block(const WideQuery& query, const Ray& ray, const FloatRay& r,
                          const Block& block, Nearest& nearest) {
  for (int first = 0; kSpheres && first < kWidth && is_sphere(block, first);
       first += kSphereLanes) {
    for (std::uint32_t mask = possible_spheres(block, first, r); mask != 0; mask &= mask - 1) {
      ask(query, ray, r, block.primitive[first + __builtin_ctz(mask)], nearest);
    }
  }
  meet_triangles<kEnds>(query, ray, r, block, nearest);
}

// Afterwards `sure`, if there is one, is still to be decided.
template <bool kSpheres>
PT_INLINE void search_tree(const WideQuery& query, const Ray& ray, const FloatRay& r,
                           Nearest& nearest) {
  const Node* nodes = static_cast<const Node*>(query.view.nodes);
  const Block* blocks = static_cast<const Block*>(query.view.blocks);
  Stack stack;
  WideRef ref = query.view.root;
  for (;;) {
    if (!(ref & kLeaf)) {
      const Entered entered = enter_children(nodes[ref], r, nearest.t_max);
      if (entered.mask != 0) {
        ref = push_children(nodes[ref], entered.t, entered.mask, stack);
        continue;
      }
    } else {
      meet_block<kSpheres, false>(query, ray, r, blocks[ref & ~kLeaf], nearest);
    }
    do {
      if (stack.size == 0) return;
      --stack.size;
    } while (stack.enter[stack.size] > nearest.t_max);
    ref = stack.ref[stack.size];
  }
}

// A scene of one block, a tree with spheres and a tree without have separate code, so that none
// pays for what it does not have. Without kSettled `sure`, if any, is still to be decided.
template <bool kSettled>
PT_INLINE void search(const WideQuery& query, const Ray& ray, const FloatRay& r, Nearest& nearest) {
  const WideView& view = query.view;
  if (view.root & kLeaf) {
    const Block& block = static_cast<const Block*>(view.blocks)[view.root & ~kLeaf];
    meet_block<true, true>(query, ray, r, block, nearest);
  } else if (view.has_spheres) {
    search_tree<true>(query, ray, r, nearest);
  } else {
    search_tree<false>(query, ray, r, nearest);
  }
  if (kSettled) settle(query, ray, nearest);
}

}  // namespace
}  // namespace pt
