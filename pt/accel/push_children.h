// What the queries have still to visit. Internal like simd.h.
#pragma once

#include "pt/accel/node_test.h"

namespace pt {
namespace {

// A node that is left leaves all its children but one behind; whole vectors are written at the top.
constexpr int kStack = kMaxTreeDepth * (kWidth - 1) + 1 + kWidth;

struct Stack {
  int size = 0;
  float enter[kStack];  // no later than the ray enters the box
  WideRef ref[kStack];
};

// Pushes the children of `mask`, in any order, and returns how many.
PT_INLINE int push_others(const Node& node, std::uint32_t mask, WideRef* top) {
#if defined(__AVX512F__)
  const __m512i child = _mm512_load_si512(node.child);
  _mm512_storeu_si512(top, _mm512_maskz_compress_epi32(static_cast<__mmask16>(mask), child));
  return __builtin_popcount(mask);
#else
  int count = 0;
  for (; mask != 0; mask &= mask - 1) top[count++] = node.child[__builtin_ctz(mask)];
  return count;
#endif
}

// Any number of children, by insertion.
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

#if defined(__AVX512F__)

// One layer of a sorting network: lanes exchange with those that `order` names, and those of
// `upper` take the smaller.
template <int order, int upper>
PT_INLINE __m128i sort_layer(__m128i a) {
  const __m128i b = _mm_shuffle_epi32(a, order);
  return _mm_blend_epi32(_mm_max_epi32(a, b), _mm_min_epi32(a, b), upper);
}

// Up to four children: the distance's last four bits give way to the slot while a network sorts,
// the farthest first.
PT_INLINE WideRef push_few(const Node& node, __m512 enter, std::uint32_t mask, Stack& stack) {
  const __m512i slots = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
  const __m512i bits = _mm512_castps_si512(enter);
  // (bits & ~15) | slots
  const __m512i keys = _mm512_ternarylogic_epi32(bits, _mm512_set1_epi32(15), slots, 0xba);
  __m128i four =
      _mm512_castsi512_si128(_mm512_maskz_compress_epi32(static_cast<__mmask16>(mask), keys));
  four = sort_layer<_MM_SHUFFLE(2, 3, 0, 1), 0b1010>(four);
  four = sort_layer<_MM_SHUFFLE(0, 1, 2, 3), 0b1100>(four);
  four = sort_layer<_MM_SHUFFLE(2, 3, 0, 1), 0b1010>(four);
  const __m512i refs = _mm512_maskz_permutexvar_epi32(0xffff, _mm512_castsi128_si512(four),
                                                      _mm512_load_si512(node.child));
  four = _mm_andnot_si128(_mm_set1_epi32(15), four);
  _mm_storeu_si128(reinterpret_cast<__m128i*>(stack.enter + stack.size), four);
  _mm_storeu_si128(reinterpret_cast<__m128i*>(stack.ref + stack.size),
                   _mm512_castsi512_si128(refs));
  stack.size += __builtin_popcount(mask) - 1;
  return stack.ref[stack.size];
}

#endif

// Pushes all children but the nearest, the farther the deeper, and returns the nearest.
PT_INLINE WideRef push_children(const Node& node, Floats<kWidth> enter, std::uint32_t mask,
                                Stack& stack) {
  if ((mask & (mask - 1)) == 0) return node.child[__builtin_ctz(mask)];
#if defined(__AVX512F__)
  if (__builtin_popcount(mask) <= 4) return push_few(node, (__m512)enter, mask, stack);
#endif
  alignas(4 * kWidth) float t[kWidth];
  store<kWidth>(t, enter);
  return push_many(node, t, mask, stack);
}

}  // namespace
}  // namespace pt
