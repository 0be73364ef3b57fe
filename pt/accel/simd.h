// Several floats at once, with the vector extensions of gcc and clang: + - * work lane by lane,
// also with one float for all lanes. Operations that the extensions lack are below; they use the
// machine's instruction if there is one. traverse.h alone includes this file, and is compiled for
// several instruction sets. So all is internal: the linker must not mix the sets.
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

#if !defined(__AVX__)
// Compares eight lanes as twice four: if the machine has fewer lanes than a comparison, g++ makes
// it lane by lane.
template <class Eight, class Four>
struct Halves {
  Four low;
  Four high;
  explicit Halves(Eight a) { __builtin_memcpy(this, &a, sizeof a); }
  Halves(Four first, Four second) : low(first), high(second) {}
  operator Eight() const {
    Eight a;
    __builtin_memcpy(&a, this, sizeof a);
    return a;
  }
};
using FloatHalves = Halves<Floats<8>, Floats<4>>;
using IntHalves = Halves<Ints<8>, Ints<4>>;
#endif

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

// The smaller and the larger number; b if either is NaN. (The maskless intrinsics make g++ 12 warn
// of an uninitialised value in its own header; a mask of all lanes is the same instruction.)
template <int W>
PT_INLINE Floats<W> min(Floats<W> a, Floats<W> b) {
#if defined(__AVX512F__)
  if constexpr (W == 16) return (Floats<W>)_mm512_maskz_min_ps(0xffff, (__m512)a, (__m512)b);
#endif
#if defined(__AVX__)
  if constexpr (W == 8) return (Floats<W>)_mm256_min_ps((__m256)a, (__m256)b);
#else
  if constexpr (W == 8) {
    const FloatHalves x(a), y(b);
    return FloatHalves(min<4>(x.low, y.low), min<4>(x.high, y.high));
  }
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
#else
  if constexpr (W == 8) {
    const FloatHalves x(a), y(b);
    return FloatHalves(max<4>(x.low, y.low), max<4>(x.high, y.high));
  }
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

// Bit i is the sign bit of lane i, so it is set if a comparison is true. There is no branch.
template <int W>
PT_INLINE std::uint32_t bits(Ints<W> a) {
#if defined(__AVX512DQ__)
  if constexpr (W == 16) return _mm512_movepi32_mask((__m512i)a);
#endif
#if defined(__AVX__)
  if constexpr (W == 8) return static_cast<std::uint32_t>(_mm256_movemask_ps((__m256)a));
#else
  if constexpr (W == 8) return bits<4>(IntHalves(a).low) | bits<4>(IntHalves(a).high) << 4;
#endif
#if defined(__SSE2__)
  if constexpr (W == 4) return static_cast<std::uint32_t>(_mm_movemask_ps((__m128)a));
#endif
  std::uint32_t result = 0;
  for (int i = 0; i < W; ++i) result |= static_cast<std::uint32_t>(a[i]) >> 31 << i;
  return result;
}

// The opposite: lane i is all ones if bit i of `mask` is set.
template <int W>
PT_INLINE Ints<W> lanes(std::uint32_t mask) {
#if !defined(__AVX__)
  if constexpr (W == 8) return IntHalves(lanes<4>(mask), lanes<4>(mask >> 4));
#endif
  Ints<W> bit;
  for (int i = 0; i < W; ++i) bit[i] = 1 << i;
  return (bit & static_cast<std::int32_t>(mask)) != 0;
}

#if defined(__AVX2__)
// For each mask of eight bits, the numbers of its set bits, in order, one byte each. (pdep and pext
// need no table, but take a hundred cycles on AMD's processors before Zen 3.)
struct SetBits {
  std::uint64_t of[256];
};
constexpr SetBits set_bits() {
  SetBits bits{};
  for (int mask = 0; mask < 256; ++mask) {
    int count = 0;
    for (int i = 0; i < 8; ++i) {
      if (mask >> i & 1) bits.of[mask] |= static_cast<std::uint64_t>(i) << (8 * count++);
    }
  }
  return bits;
}
constexpr SetBits kSetBits = set_bits();

// The lanes of `mask`, in order, then arbitrary lanes.
PT_INLINE __m256i packed(__m256i a, std::uint32_t mask) {
  const __m128i bytes = _mm_cvtsi64_si128(static_cast<long long>(kSetBits.of[mask]));
  return _mm256_permutevar8x32_epi32(a, _mm256_cvtepu8_epi32(bytes));
}
#endif
#if defined(__AVX512F__)
PT_INLINE __m512i packed(__m512i a, std::uint32_t mask) {
  return _mm512_maskz_compress_epi32(static_cast<__mmask16>(mask), a);  // then zeros
}
#endif

// Copies from[i] for every bit i of `mask`, in order. It may also overwrite the places after them,
// up to W in all. `from` is aligned to 4 W bytes.
template <int W>
PT_INLINE void copy_packed(const std::uint32_t* from, std::uint32_t mask, std::uint32_t* to) {
#if defined(__AVX512F__)
  if constexpr (W == 16) return _mm512_storeu_si512(to, packed(_mm512_load_si512(from), mask));
#endif
#if defined(__AVX2__)
  if constexpr (W == 8) {
    const __m256i all = _mm256_load_si256(reinterpret_cast<const __m256i*>(from));
    return _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), packed(all, mask));
  }
#endif
  for (; mask != 0; mask &= mask - 1) *to++ = from[__builtin_ctz(mask)];
}

// Bit i is set where a <= b in lane i; not where either is NaN.
template <int W>
PT_INLINE std::uint32_t less_equal(Floats<W> a, Floats<W> b) {
#if defined(__AVX512VL__)
  if constexpr (W == 16) return _mm512_cmp_ps_mask((__m512)a, (__m512)b, _CMP_LE_OQ);
  if constexpr (W == 8) return _mm256_cmp_ps_mask((__m256)a, (__m256)b, _CMP_LE_OQ);
  if constexpr (W == 4) return _mm_cmp_ps_mask((__m128)a, (__m128)b, _CMP_LE_OQ);
#endif
#if !defined(__AVX__)
  if constexpr (W == 8) {
    const FloatHalves x(a), y(b);
    return less_equal<4>(x.low, y.low) | less_equal<4>(x.high, y.high) << 4;
  }
#endif
  return bits<W>(a <= b);
}

// Lane i is that of a if bit i of `mask` is set, else that of b.
template <int W>
PT_INLINE Floats<W> choose(std::uint32_t mask, Floats<W> a, Floats<W> b) {
#if defined(__AVX512VL__)
  if constexpr (W == 16) {
    return (Floats<W>)_mm512_mask_blend_ps(static_cast<__mmask16>(mask), (__m512)b, (__m512)a);
  }
  if constexpr (W == 8) {
    return (Floats<W>)_mm256_mask_blend_ps(static_cast<__mmask8>(mask), (__m256)b, (__m256)a);
  }
  if constexpr (W == 4) {
    return (Floats<W>)_mm_mask_blend_ps(static_cast<__mmask8>(mask), (__m128)b, (__m128)a);
  }
#endif
  const Ints<W> those = lanes<W>(mask);
  return (Floats<W>)((those & (Ints<W>)a) | (~those & (Ints<W>)b));
}

template <int W>
PT_INLINE Floats<W> square_root(Floats<W> a) {
#if defined(__AVX512F__)
  if constexpr (W == 16) return (Floats<W>)_mm512_maskz_sqrt_ps(0xffff, (__m512)a);
#endif
#if defined(__AVX__)
  if constexpr (W == 8) return (Floats<W>)_mm256_sqrt_ps((__m256)a);
#endif
#if defined(__SSE2__)
  if constexpr (W == 4) return (Floats<W>)_mm_sqrt_ps((__m128)a);
#endif
  for (int i = 0; i < W; ++i) a[i] = __builtin_sqrtf(a[i]);
  return a;
}

// Points or directions, with a row per component. `p` is x, y, z.
template <int W>
struct Lanes3 {
  Floats<W> x;
  Floats<W> y;
  Floats<W> z;
};
template <int W>
PT_INLINE Lanes3<W> splat3(const float* p) {
  return {splat<W>(p[0]), splat<W>(p[1]), splat<W>(p[2])};
}
template <int W>
PT_INLINE Lanes3<W> operator-(const Lanes3<W>& a, const Lanes3<W>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <int W>
PT_INLINE Lanes3<W> magnitude(const Lanes3<W>& a) {
  return {magnitude<W>(a.x), magnitude<W>(a.y), magnitude<W>(a.z)};
}
template <int W>
PT_INLINE Floats<W> dot(const Lanes3<W>& a, const Lanes3<W>& b) {
  return multiply_add<W>(a.z, b.z, multiply_add<W>(a.y, b.y, a.x * b.x));
}
template <int W>
PT_INLINE Lanes3<W> cross(const Lanes3<W>& a, const Lanes3<W>& b) {
  return {multiply_subtract<W>(a.y, b.z, a.z * b.y), multiply_subtract<W>(a.z, b.x, a.x * b.z),
          multiply_subtract<W>(a.x, b.y, a.y * b.x)};
}

// The numbers from low to high.
template <int W>
struct Range {
  Floats<W> low;
  Floats<W> high;
};

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
#if !defined(__AVX__)
  if constexpr (W == 8) return not_equal<4>(p, a) | not_equal<4>(p + 4, a) << 4;
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
