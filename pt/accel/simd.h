// Several floats at once, by the vector extensions of gcc and clang: + - * work lane by lane, also
// with one float for all lanes. What the extensions lack is below, with the instruction where there
// is one. Included by traverse.cpp alone, which is compiled for several instruction sets; all is
// internal, so that no function compiled for one of them stands in for another.
#pragma once

#include <cstdint>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#define PT_INLINE static inline __attribute__((always_inline))

namespace pt {
namespace {

template <int W>
struct LanesOf {
  typedef float Floats __attribute__((vector_size(4 * W)));
  typedef std::int32_t Ints __attribute__((vector_size(4 * W)));
};
template <int W>
using Floats = typename LanesOf<W>::Floats;
template <int W>
using Ints = typename LanesOf<W>::Ints;

// `p` is aligned to 4 W bytes.
template <int W>
PT_INLINE Floats<W> load(const float* p) {
  Floats<W> a;
  __builtin_memcpy(&a, __builtin_assume_aligned(p, 4 * W), sizeof a);
  return a;
}
template <int W>
PT_INLINE void store(float* p, Floats<W> a) {
  __builtin_memcpy(__builtin_assume_aligned(p, 4 * W), &a, sizeof a);
}
template <int W>
PT_INLINE void store(std::int32_t* p, Ints<W> a) {
  __builtin_memcpy(__builtin_assume_aligned(p, 4 * W), &a, sizeof a);
}
template <int W>
PT_INLINE Floats<W> splat(float a) {
  return a - Floats<W>{};
}

// a b + c, a b - c and c - a b: rounded once or twice, whichever is faster.
template <int W>
PT_INLINE Floats<W> multiply_add(Floats<W> a, Floats<W> b, Floats<W> c) {
#if defined(__AVX512F__)
  if constexpr (W == 16) return (Floats<W>)_mm512_fmadd_ps((__m512)a, (__m512)b, (__m512)c);
#endif
#if defined(__FMA__)
  if constexpr (W == 8) return (Floats<W>)_mm256_fmadd_ps((__m256)a, (__m256)b, (__m256)c);
  if constexpr (W == 4) return (Floats<W>)_mm_fmadd_ps((__m128)a, (__m128)b, (__m128)c);
#endif
  return a * b + c;
}
template <int W>
PT_INLINE Floats<W> multiply_subtract(Floats<W> a, Floats<W> b, Floats<W> c) {
  return multiply_add<W>(a, b, -c);
}

// The smaller and the larger; if either is NaN, b. (The maskless intrinsics make g++ 12 warn of an
// uninitialised value in its own header; a mask of all lanes is the same instruction.)
template <int W>
PT_INLINE Floats<W> min(Floats<W> a, Floats<W> b) {
#if defined(__AVX512F__)
  if constexpr (W == 16) return (Floats<W>)_mm512_maskz_min_ps(0xffff, (__m512)a, (__m512)b);
#endif
#if defined(__AVX__)
  if constexpr (W == 8) return (Floats<W>)_mm256_min_ps((__m256)a, (__m256)b);
#endif
#if defined(__SSE2__)
  if constexpr (W == 4) return (Floats<W>)_mm_min_ps((__m128)a, (__m128)b);
#endif
  return a < b ? a : b;
}
template <int W>
PT_INLINE Floats<W> max(Floats<W> a, Floats<W> b) {
#if defined(__AVX512F__)
  if constexpr (W == 16) return (Floats<W>)_mm512_maskz_max_ps(0xffff, (__m512)a, (__m512)b);
#endif
#if defined(__AVX__)
  if constexpr (W == 8) return (Floats<W>)_mm256_max_ps((__m256)a, (__m256)b);
#endif
#if defined(__SSE2__)
  if constexpr (W == 4) return (Floats<W>)_mm_max_ps((__m128)a, (__m128)b);
#endif
  return a > b ? a : b;
}

// The sign bits of a, a without them, and a with the bits `sign` flipped.
template <int W>
PT_INLINE Ints<W> sign_of(Floats<W> a) {
  return (Ints<W>)a & std::int32_t(0x80000000);
}
template <int W>
PT_INLINE Floats<W> magnitude(Floats<W> a) {
  return (Floats<W>)((Ints<W>)a & std::int32_t(0x7fffffff));
}
template <int W>
PT_INLINE Floats<W> flip(Floats<W> a, Ints<W> sign) {
  return (Floats<W>)((Ints<W>)a ^ sign);
}

// Bit i is set where lane i of a comparison's result is true. Without a branch.
template <int W>
PT_INLINE std::uint32_t bits(Ints<W> yes) {
#if defined(__AVX__)
  if constexpr (W == 8) return static_cast<std::uint32_t>(_mm256_movemask_ps((__m256)yes));
#endif
#if defined(__SSE2__)
  if constexpr (W == 4) return static_cast<std::uint32_t>(_mm_movemask_ps((__m128)yes));
#endif
#if !defined(__AVX__) && defined(__SSE2__)
  if constexpr (W == 8) {
    __m128 half[2];
    __builtin_memcpy(half, &yes, sizeof half);
    return static_cast<std::uint32_t>(_mm_movemask_ps(half[0]) | _mm_movemask_ps(half[1]) << 4);
  }
#endif
  std::uint32_t result = 0;
  for (int i = 0; i < W; ++i) result |= static_cast<std::uint32_t>(yes[i] & 1) << i;
  return result;
}

// Bit i is set where a <= b in lane i; not where either is NaN.
template <int W>
PT_INLINE std::uint32_t less_equal(Floats<W> a, Floats<W> b) {
#if defined(__AVX512VL__)
  if constexpr (W == 16) return _mm512_cmp_ps_mask((__m512)a, (__m512)b, _CMP_LE_OQ);
  if constexpr (W == 8) return _mm256_cmp_ps_mask((__m256)a, (__m256)b, _CMP_LE_OQ);
#endif
  return bits<W>(a <= b);
}

// Bit i is set where p[i] != a. `p` is aligned to 4 W bytes.
template <int W>
PT_INLINE std::uint32_t not_equal(const std::uint32_t* p, std::uint32_t a) {
  Ints<W> all;
  __builtin_memcpy(&all, __builtin_assume_aligned(p, 4 * W), sizeof all);
#if defined(__AVX512VL__)
  if constexpr (W == 8) {
    return _mm256_cmpneq_epi32_mask((__m256i)all, _mm256_set1_epi32(static_cast<int>(a)));
  }
#endif
#if defined(__AVX512VL__)
  if constexpr (W == 16) {
    return _mm512_cmpneq_epi32_mask((__m512i)all, _mm512_set1_epi32(static_cast<int>(a)));
  }
#endif
  return bits<W>(all != static_cast<std::int32_t>(a));
}

}  // namespace
}  // namespace pt
