// The stack of nodes that a query has still to visit. Internal like simd.h.
#pragma once

#include "pt/accel/node_test.h"

namespace pt {
namespace {

// Each level of the tree leaves at most kWidth - 1 children here; the top is written in whole vectors.
constexpr int kStack = kMaxTreeDepth * (kWidth - 1) + 1 + kWidth;

struct Stack {
  int size = 0;
  float enter[kStack];  // no later than the ray enters the box
  WideRef ref[kStack];
};

// Pushes the children of `mask`, in any order, and returns how many.
PT_INLINE int push_others(const Node& node, std::uint32_t mask, WideRef* top) {
  copy_packed<kWidth>(node.child, mask, top);
  return __builtin_popcount(mask);
}

// Pushes any number of children, sorted by insertion.
PT_INLINE WideRef push_many(const Node& node, const float* enter, std::uint32_t mask,
                            Stack& stack) {
  const int base = stack.size;
  for (; mask != 0; mask &= mask - 1) {
    const int i = __builtin_ctz(mask);
    const float t = enter[i];
    int at = stack.size++;
    for (; at > base && stack.enter[at - 1] < t; --at) {
      stack.enter[at] = stack.enter[at - 1];
      stack.ref[at] = stack.ref[at - 1];
    }
    stack.enter[at] = t;
    stack.ref[at] = node.child[i];
  }
  return stack.ref[--stack.size];
}

#if defined(__AVX2__)

// One layer of a sorting network: lanes exchange with those of `b`, and those of `upper` take the
// smaller.
template <int upper>
PT_INLINE __m128i exchange(__m128i a, __m128i b) {
  return _mm_blend_epi32(_mm_max_epi32(a, b), _mm_min_epi32(a, b), upper);
}
template <int upper>
PT_INLINE __m256i exchange(__m256i a, __m256i b) {
  return _mm256_blend_epi32(_mm256_max_epi32(a, b), _mm256_min_epi32(a, b), upper);
}

// The largest first.
PT_INLINE __m128i sorted(__m128i a) {
  a = exchange<0xa>(a, _mm_shuffle_epi32(a, _MM_SHUFFLE(2, 3, 0, 1)));
  a = exchange<0xc>(a, _mm_shuffle_epi32(a, _MM_SHUFFLE(0, 1, 2, 3)));
  return exchange<0xa>(a, _mm_shuffle_epi32(a, _MM_SHUFFLE(2, 3, 0, 1)));
}
PT_INLINE __m256i sorted(__m256i a) {
  a = exchange<0xaa>(a, _mm256_shuffle_epi32(a, _MM_SHUFFLE(2, 3, 0, 1)));
  a = exchange<0xcc>(a, _mm256_shuffle_epi32(a, _MM_SHUFFLE(0, 1, 2, 3)));
  a = exchange<0xaa>(a, _mm256_shuffle_epi32(a, _MM_SHUFFLE(2, 3, 0, 1)));
  a = exchange<0xf0>(a, _mm256_permutevar8x32_epi32(a, _mm256_setr_epi32(7, 6, 5, 4, 3, 2, 1, 0)));
  a = exchange<0xcc>(a, _mm256_shuffle_epi32(a, _MM_SHUFFLE(1, 0, 3, 2)));
  return exchange<0xaa>(a, _mm256_shuffle_epi32(a, _MM_SHUFFLE(2, 3, 0, 1)));
}

// The lanes of a for which bit i of the mask is set, in order, then zeros; the same for children.
#if defined(__AVX512F__)
PT_INLINE __m256i first_eight(NodeFloats a, std::uint32_t mask, int) {
  return _mm512_castsi512_si256(packed((__m512i)a, mask));
}
PT_INLINE __m256i pick(const Node& node, __m256i slots) {
  return _mm512_castsi512_si256(_mm512_maskz_permutexvar_epi32(
      0xffff, _mm512_castsi256_si512(slots), (__m512i)children(node)));
}
#else
PT_INLINE __m256i first_eight(NodeFloats a, std::uint32_t mask, int count) {
  return _mm256_and_si256(packed((__m256i)a, mask), (__m256i)lanes<8>((1u << count) - 1));
}
PT_INLINE __m256i pick(const Node& node, __m256i slots) {
  return _mm256_permutevar8x32_epi32((__m256i)children(node), slots);
}
#endif

// Pushes up to eight children, sorted by a network. The last bits of each distance are replaced by
// the child's slot, so that both are sorted as one number.
PT_INLINE WideRef push_few(const Node& node, NodeFloats enter, std::uint32_t mask, int count,
                           Stack& stack) {
  constexpr int kSlot = kWidth - 1;
  Ints<kWidth> slots;
  for (int i = 0; i < kWidth; ++i) slots[i] = i;
  const NodeFloats keys = (NodeFloats)(((Ints<kWidth>)enter & ~kSlot) | slots);
  const __m256i those = first_eight(keys, mask, count);
  const __m256i order =
      count <= 4 ? _mm256_castsi128_si256(sorted(_mm256_castsi256_si128(those))) : sorted(those);
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(stack.enter + stack.size),
                      _mm256_andnot_si256(_mm256_set1_epi32(kSlot), order));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(stack.ref + stack.size), pick(node, order));
  stack.size += count - 1;
  return stack.ref[stack.size];
}

#endif

// Pushes all children except the nearest, which it returns. The farthest child is deepest.
PT_INLINE WideRef push_children(const Node& node, NodeFloats enter, std::uint32_t mask,
                                Stack& stack) {
  if ((mask & (mask - 1)) == 0) return node.child[__builtin_ctz(mask)];
#if defined(__AVX2__)
  const int count = __builtin_popcount(mask);
  if (count <= 8) return push_few(node, enter, mask, count, stack);
#endif
  alignas(4 * kWidth) float t[kWidth];
  store<kWidth>(t, enter);
  return push_many(node, t, mask, stack);
}

}  // namespace
}  // namespace pt
