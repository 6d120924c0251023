// Gives eight doubles that compute side by side, and says which instruction set this processor offers.
//
// Kernels are headers "*.kernel.hpp", compiled once for each instruction set into a namespace of that name
// (cmake/FiberfateKernels.cmake) and chosen at run time (base/kernels.hpp). They must not instantiate
// anything of the standard library or Eigen: the linker would keep one copy, perhaps the one that this
// processor cannot run.
#pragma once

#include <cstdint>

#if defined(FIBERFATE_ISA) && defined(__AVX2__)
#include <immintrin.h>
#endif

namespace fiberfate {

/// The instruction sets for which kernels are compiled.
enum class InstructionSet { baseline, avx2, avx512 };

/// The best instruction set of this processor; the environment variable FIBERFATE_ISA
/// ("baseline", "avx2", "avx512") asks for a lesser one.
[[nodiscard]] InstructionSet instruction_set();
[[nodiscard]] const char* name(InstructionSet set);

}  // namespace fiberfate

#ifdef FIBERFATE_ISA
namespace fiberfate::FIBERFATE_ISA {

inline constexpr int lanes = 8;
typedef double Pack __attribute__((vector_size(64)));
typedef std::int64_t Mask __attribute__((vector_size(64)));

static inline __attribute__((always_inline)) Pack load(const double* from) {
  return *reinterpret_cast<const Pack*>(from);
}
static inline __attribute__((always_inline)) void store(double* to, const Pack& pack) {
  *reinterpret_cast<Pack*>(to) = pack;
}
static inline __attribute__((always_inline)) Pack broadcast(double x) {
  return Pack{x, x, x, x, x, x, x, x};
}
/// Takes `yes` where the mask is set, else `no`.
static inline __attribute__((always_inline)) Pack choose(const Mask& mask, const Pack& yes, const Pack& no) {
  return mask ? yes : no;
}
static inline __attribute__((always_inline)) Pack smaller(const Pack& a, const Pack& b) {
  return a < b ? a : b;
}
static inline __attribute__((always_inline)) Pack larger(const Pack& a, const Pack& b) {
  return a > b ? a : b;
}
static inline __attribute__((always_inline)) Pack clamp(const Pack& x, double low, double high) {
  return smaller(larger(x, broadcast(low)), broadcast(high));
}
static inline __attribute__((always_inline)) Pack square_root(const Pack& x) {
  Pack root;
  for (int i = 0; i < lanes; ++i) root[i] = __builtin_sqrt(x[i]);
  return root;
}

/// Exponential function to about two units in the last place; x is clamped to [−700, 700].
static inline __attribute__((always_inline)) Pack exponential_of(const Pack& x) {
  const Pack bounded = clamp(x, -700, 700);
  // x = n ln 2 + r; adding and taking away 1.5 · 2^52 rounds n to an integer and leaves it in the low bits.
  const double magic = 6755399441055744.0;
  const Pack shifted = bounded * 1.4426950408889634074 + magic;
  const Pack n = shifted - magic;
  const Pack r = (bounded - n * 6.93147180369123816490e-01) - n * 1.90821492927058770002e-10;
  // Taylor series of degree 13: |r| <= ln 2 / 2 leaves less than 1e-17.
  Pack sum = broadcast(1.0 / 6227020800.0);
  const double inverse_factorials[13] = {
      1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720,
      1.0 / 120,       1.0 / 24,       1.0 / 6,       0.5,          1.0,         1.0};
  for (int i = 0; i < 13; ++i) sum = sum * r + inverse_factorials[i];
  const Mask exponent = reinterpret_cast<Mask>(shifted) << 52;
  const Mask power = exponent + (std::int64_t{1023} << 52);
  return sum * reinterpret_cast<Pack>(power);
}

/// Eight indices.
typedef std::int32_t IndexPack __attribute__((vector_size(32)));
typedef std::int32_t UnalignedIndexPack __attribute__((vector_size(32), aligned(4)));

static inline __attribute__((always_inline)) IndexPack read_indices(const std::int32_t* from) {
  return *reinterpret_cast<const UnalignedIndexPack*>(from);
}
/// Eight floats.
typedef float HalfFloats __attribute__((vector_size(32)));

/// Reads the floats with the given indices.
static inline __attribute__((always_inline)) HalfFloats gather(const float* from, const IndexPack& index) {
#if defined(__AVX2__)
  return reinterpret_cast<HalfFloats>(_mm256_i32gather_ps(from, reinterpret_cast<__m256i>(index), 4));
#else
  HalfFloats gathered;
  for (int lane = 0; lane < lanes; ++lane) gathered[lane] = from[index[lane]];
  return gathered;
#endif
}

/// Reads the integers with the given indices.
static inline __attribute__((always_inline)) IndexPack gather(const std::int32_t* from,
                                                              const IndexPack& index) {
#if defined(__AVX2__)
  return reinterpret_cast<IndexPack>(_mm256_i32gather_epi32(from, reinterpret_cast<__m256i>(index), 4));
#else
  IndexPack gathered;
  for (int lane = 0; lane < lanes; ++lane) gathered[lane] = from[index[lane]];
  return gathered;
#endif
}

/// Gathers the lanes of a comparison into the bits of a number.
static inline __attribute__((always_inline)) std::uint32_t to_bits(const Mask& mask) {
#if defined(__AVX512DQ__)
  return _mm512_movepi64_mask(reinterpret_cast<const __m512i&>(mask));
#else
  std::uint32_t bits = 0;
  for (int lane = 0; lane < lanes; ++lane) bits |= (mask[lane] != 0 ? 1U : 0U) << lane;
  return bits;
#endif
}

/// Writes the doubles whose bits are set, one after the other; up to eight may be overwritten.
static inline __attribute__((always_inline)) void write_selected(double* to, const Pack& from,
                                                                 std::uint32_t bits) {
#if defined(__AVX512F__)
  _mm512_storeu_pd(to,
                   _mm512_maskz_compress_pd(static_cast<__mmask8>(bits), reinterpret_cast<__m512d>(from)));
#else
  for (; bits != 0; bits &= bits - 1) *to++ = from[__builtin_ctz(bits)];
#endif
}

/// Writes the indices whose bits are set, one after the other; up to eight may be overwritten.
static inline __attribute__((always_inline)) void write_selected(std::int32_t* to, const IndexPack& from,
                                                                 std::uint32_t bits) {
#if defined(__AVX512VL__)
  const __m256i packed =
      _mm256_maskz_compress_epi32(static_cast<__mmask8>(bits), reinterpret_cast<__m256i>(from));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), packed);
#else
  for (; bits != 0; bits &= bits - 1) *to++ = from[__builtin_ctz(bits)];
#endif
}

/// Sixteen floats that compute side by side, for culling.
inline constexpr int float_lanes = 16;
typedef float Floats __attribute__((vector_size(64)));
typedef std::int32_t FloatMask __attribute__((vector_size(64)));
/// Sixteen integers.
typedef FloatMask Integers;
typedef std::int32_t UnalignedIntegers __attribute__((vector_size(64), aligned(4)));
typedef float UnalignedFloats __attribute__((vector_size(64), aligned(4)));

static inline __attribute__((always_inline)) Floats read_floats(const float* from) {
  return *reinterpret_cast<const UnalignedFloats*>(from);
}
static inline __attribute__((always_inline)) Integers read_integers(const std::int32_t* from) {
  return *reinterpret_cast<const UnalignedIntegers*>(from);
}
static inline __attribute__((always_inline)) Floats clamp(const Floats& x, const Floats& low,
                                                          const Floats& high) {
  const Floats lifted = x < low ? low : x;
  return lifted > high ? high : lifted;
}

static inline __attribute__((always_inline)) Floats square_root(const Floats& x) {
  Floats root;
  for (int i = 0; i < float_lanes; ++i) root[i] = __builtin_sqrtf(x[i]);
  return root;
}

/// Reads the floats with the given sixteen indices.
static inline __attribute__((always_inline)) Floats gather(const float* from, const std::int32_t* index) {
#if defined(__AVX512F__)
  return reinterpret_cast<Floats>(_mm512_i32gather_ps(_mm512_loadu_si512(index), from, 4));
#else
  Floats gathered;
  for (int lane = 0; lane < float_lanes; ++lane) gathered[lane] = from[index[lane]];
  return gathered;
#endif
}

/// Reads the integers with the given sixteen indices.
static inline __attribute__((always_inline)) Integers gather_integers(const std::int32_t* from,
                                                                      const std::int32_t* index) {
#if defined(__AVX512F__)
  return reinterpret_cast<Integers>(_mm512_i32gather_epi32(_mm512_loadu_si512(index), from, 4));
#else
  Integers gathered;
  for (int lane = 0; lane < float_lanes; ++lane) gathered[lane] = from[index[lane]];
  return gathered;
#endif
}

/// Gathers the lanes of a comparison into the bits of a number.
static inline __attribute__((always_inline)) std::uint32_t to_bits(const FloatMask& mask) {
#if defined(__AVX512DQ__)
  return _mm512_movepi32_mask(reinterpret_cast<const __m512i&>(mask));
#elif defined(__AVX2__)
  const __m256* halves = reinterpret_cast<const __m256*>(&mask);
  return static_cast<std::uint32_t>(_mm256_movemask_ps(halves[0]) | (_mm256_movemask_ps(halves[1]) << 8));
#else
  std::uint32_t bits = 0;
  for (int lane = 0; lane < float_lanes; ++lane) bits |= (mask[lane] != 0 ? 1U : 0U) << lane;
  return bits;
#endif
}

/// Selects the first `count` bits (all sixteen when there are more).
static inline __attribute__((always_inline)) std::uint32_t first_bits(int count) {
  return count < float_lanes ? (1U << count) - 1U : 0xFFFFU;
}

/// Writes the sixteen numbers whose bits are set, one after the other; up to sixteen may be overwritten.
static inline __attribute__((always_inline)) int write_selected(std::int32_t* to, const std::int32_t* from,
                                                                std::uint32_t bits) {
#if defined(__AVX512F__)
  const __m512i packed = _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), _mm512_loadu_si512(from));
  _mm512_storeu_si512(to, packed);
  return __builtin_popcount(bits);
#else
  int count = 0;
  for (; bits != 0; bits &= bits - 1) to[count++] = from[__builtin_ctz(bits)];
  return count;
#endif
}

}  // namespace fiberfate::FIBERFATE_ISA
#endif
