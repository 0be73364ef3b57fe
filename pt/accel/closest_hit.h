// The nearest hit of one ray. Internal like simd.h.
#pragma once

#include "pt/accel/block_test.h"
#include "pt/accel/decide.h"
#include "pt/accel/kernel.h"
#include "pt/accel/node_test.h"
#include "pt/accel/push_children.h"

namespace pt {
namespace {

// Of several hits at the same t, the primitive with the smallest index counts.
PT_INLINE bool offer(const ExactHit& hit, std::uint32_t primitive, WideHit& best) {
  if (!hit.hit || hit.t > best.hit.t || (hit.t == best.hit.t && primitive > best.primitive)) {
    return false;
  }
  best = {hit, primitive};
  return true;
}

// The nearest hit so far: `best` has been decided; `sure` is a triangle that is hit for certain,
// somewhere between t_low and t_max, and nearer than all that was decided. Most rays decide one
// triangle, the last.
struct Nearest {
  WideHit best;
  std::uint32_t sure = kNothing;
  float t_low = 0;
  float t_max;
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

PT_INLINE void meet_block(const WideQuery& query, const Ray& ray, const FloatRay& r,
                          const Block& block, Nearest& nearest) {
  const Verdict<kWidth> verdict = test_block(block, r, nearest.t_max);
  if (verdict.maybe == 0) return;
  const std::uint32_t surely = verdict.surely();
  alignas(64) float low[kWidth], high[kWidth];
  const Floats<kWidth> inverse = 1 / verdict.det;
  store<kWidth>(low, (verdict.distance - verdict.error) * inverse);
  store<kWidth>(high, (verdict.distance + verdict.error) * inverse);
  for (std::uint32_t mask = verdict.maybe; mask != 0; mask &= mask - 1) {
    const int i = __builtin_ctz(mask);
    if (!(surely >> i & 1)) {
      ask(query, ray, r, block.primitive[i], nearest);
      continue;
    }
    const float t_low = low[i] * (1 - 8 * kUnit), t_high = high[i] * (1 + 8 * kUnit);
    if (t_low > nearest.t_max) continue;
    if (nearest.sure != kNothing && !(t_high < nearest.t_low)) {
      // Too close to call.
      settle(query, ray, nearest);
      ask(query, ray, r, block.primitive[i], nearest);
      continue;
    }
    nearest.sure = block.primitive[i];
    const auto* corners = reinterpret_cast<const char*>(query.triangles + nearest.sure);
    for (std::size_t at = 0; at < sizeof(Triangle); at += 64) __builtin_prefetch(corners + at);
    nearest.t_low = t_low;
    nearest.t_max = t_high < nearest.t_max ? t_high : nearest.t_max;
  }
}

PT_INLINE void trace_closest(const WideQuery& query, const Ray& ray, const FloatRay& r,
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
      meet_block(query, ray, r, blocks[ref & ~kLeaf], nearest);
    }
    do {
      if (stack.size == 0) return settle(query, ray, nearest);
      --stack.size;
    } while (stack.enter[stack.size] > nearest.t_max);
    ref = stack.ref[stack.size];
  }
}

}  // namespace
}  // namespace pt
