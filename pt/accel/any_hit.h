// Whether anything is in the way of up to kGroup rays. Internal like simd.h.
#pragma once

#include "pt/accel/block_test.h"
#include "pt/accel/decide.h"
#include "pt/accel/node_test.h"
#include "pt/accel/push_children.h"

namespace pt {
namespace {

constexpr int kGroup = 8;

// Pairs of a ray and what it has still to visit. Written whole vectors at a time.
template <int N>
struct Visits {
  int size = 0;
  WideRef ref[N + kWidth];
  std::int32_t ray[N + kWidth];

  // Adds the children of `mask`, in any order.
  void add(const Node& node, std::uint32_t mask, int i) {
#if defined(__AVX512F__)
    const __m512i child = _mm512_load_si512(node.child);
    _mm512_storeu_si512(ref + size,
                        _mm512_maskz_compress_epi32(static_cast<__mmask16>(mask), child));
    _mm512_storeu_si512(ray + size, _mm512_set1_epi32(i));
    size += __builtin_popcount(mask);
#else
    for (; mask != 0; mask &= mask - 1) {
      ref[size] = node.child[__builtin_ctz(mask)];
      ray[size++] = i;
    }
#endif
  }
};

// Eight visits at a time are taken off the end and replaced by up to kWidth times as many, one
// level further down.
constexpr int kNodeVisits = kGroup * (kWidth - 1) * kMaxTreeDepth + kGroup;
constexpr int kBlockVisits = kGroup * kWidth;

PT_INLINE std::uint32_t leaf_children(const Node& node) {
  Ints<kWidth> child;
  __builtin_memcpy(&child, node.child, sizeof child);
#if defined(__AVX512DQ__)
  if constexpr (kWidth == 16) return _mm512_movepi32_mask((__m512i)child);
#endif
  return bits<kWidth>(child < 0);
}

PT_INLINE bool is_blocked(const WideQuery& query, const Ray& ray, const FloatRay& r,
                          const Block& block) {
  const Verdict verdict = test_block(block, r, r.t_max);
  const std::uint32_t surely = verdict.maybe & verdict.surely();
  if (__builtin_expect(surely == verdict.maybe, 1)) return surely != 0;
  if (surely != 0) return true;
  for (std::uint32_t mask = verdict.maybe; mask != 0; mask &= mask - 1) {
    if (decide(query, ray, block.primitive[__builtin_ctz(mask)]).hit) return true;
  }
  return false;
}

// A ray's tests wait for each other if it goes down the tree alone, and a processor foresees badly
// where it goes next. Here all rays take their steps together, and no step of one depends on
// another's: bit i of the result says whether ray i is blocked.
PT_INLINE std::uint32_t trace_any(const WideQuery& query, const Ray* rays, const FloatRay* r,
                                  std::uint32_t valid) {
  const Node* nodes = static_cast<const Node*>(query.view.nodes);
  const Block* blocks = static_cast<const Block*>(query.view.blocks);
  Visits<kNodeVisits> inner;
  Visits<kBlockVisits> leaves;
  for (; valid != 0; valid &= valid - 1) {
    const int i = __builtin_ctz(valid);
    if (query.view.root & kLeaf) {
      leaves.ref[leaves.size] = query.view.root;
      leaves.ray[leaves.size++] = i;
    } else {
      inner.ref[inner.size] = query.view.root;
      inner.ray[inner.size++] = i;
    }
  }
  std::uint32_t blocked = 0;
  for (;;) {
    for (int k = 0; k < leaves.size; ++k) {
      const int i = leaves.ray[k];
      blocked |= static_cast<std::uint32_t>(
                     is_blocked(query, rays[i], r[i], blocks[leaves.ref[k] & ~kLeaf]))
                 << i;
    }
    leaves.size = 0;
    if (inner.size == 0) return blocked;
    const int count = inner.size < kGroup ? inner.size : kGroup;
    WideRef ref[kGroup];
    std::int32_t ray[kGroup];
    inner.size -= count;
    __builtin_memcpy(ref, inner.ref + inner.size, sizeof ref);
    __builtin_memcpy(ray, inner.ray + inner.size, sizeof ray);
    for (int k = 0; k < count; ++k) {
      const int i = ray[k];
      if (blocked >> i & 1) continue;
      const Node& node = nodes[ref[k]];
      const std::uint32_t mask = enter_children(node, r[i], r[i].t_max).mask;
      const std::uint32_t leaf = leaf_children(node);
      inner.add(node, mask & ~leaf, i);
      leaves.add(node, mask & leaf, i);
    }
  }
}

// One ray, the children of a node in any order.
PT_INLINE bool trace_one(const WideQuery& query, const Ray& ray, const FloatRay& r) {
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
    } else if (is_blocked(query, ray, r, blocks[ref & ~kLeaf])) {
      return true;
    }
    if (size == 0) return false;
    ref = stack[--size];
  }
}

PT_INLINE bool any_hit(const WideQuery& query, const Ray& ray) {
  const WideView& view = query.view;
  for (std::uint32_t k = 0; k < view.beside_count; ++k) {
    if (decide(query, ray, view.beside[k]).hit) return true;
  }
  FloatRay r;
  return view.root != kNothing && prepare(view, ray, r) && trace_one(query, ray, r);
}

PT_INLINE std::uint32_t any_hits(const WideQuery& query, const Ray* rays, int count) {
  const WideView& view = query.view;
  std::uint32_t blocked = 0, valid = 0;
  FloatRay r[kGroup];
  for (int i = 0; i < count; ++i) {
    valid |= static_cast<std::uint32_t>(prepare(view, rays[i], r[i])) << i;
    for (std::uint32_t k = 0; k < view.beside_count; ++k) {
      if (decide(query, rays[i], view.beside[k]).hit) blocked |= 1u << i;
    }
  }
  valid &= ~blocked;
  if (view.root == kNothing || valid == 0) return blocked;
  return blocked | trace_any(query, rays, r, valid);
}

}  // namespace
}  // namespace pt
