// Culls sixteen rods at a time in single precision.
#ifdef __AVX2__
#include <immintrin.h>
#endif

#include "base/simd.hpp"
#include "fibers/rod_cull.hpp"

namespace fiberfate::FIBERFATE_ISA {

namespace {
constexpr int width = 16;
typedef float Floats __attribute__((vector_size(64)));
typedef std::int32_t Bits __attribute__((vector_size(64)));
typedef float UnalignedFloats __attribute__((vector_size(64), aligned(4)));

static inline __attribute__((always_inline)) Floats read(const float* from) {
  return *reinterpret_cast<const UnalignedFloats*>(from);
}

/// Gathers the lanes of a comparison into the bits of a number.
static inline __attribute__((always_inline)) std::uint32_t to_bits(const Bits& mask) {
#if defined(__AVX512DQ__)
  return _mm512_movepi32_mask(reinterpret_cast<const __m512i&>(mask));
#elif defined(__AVX2__)
  const __m256* halves = reinterpret_cast<const __m256*>(&mask);
  return static_cast<std::uint32_t>(_mm256_movemask_ps(halves[0]) | (_mm256_movemask_ps(halves[1]) << 8));
#else
  std::uint32_t bits = 0;
  for (int lane = 0; lane < width; ++lane) bits |= (mask[lane] != 0 ? 1U : 0U) << lane;
  return bits;
#endif
}
}  // namespace

int cull_rods(const RodCull& query, Index begin, Index end, Index* found) {
  int count = 0;
  for (Index first = begin; first < end; first += width) {
    const Floats dx = read(query.midpoint_x + first) - query.x;
    const Floats dy = read(query.midpoint_y + first) - query.y;
    const Floats dz = read(query.midpoint_z + first) - query.z;
    const Floats along = dx * query.ax + dy * query.ay + dz * query.az;
    const Floats low = along < -query.half_length ? Floats{} - query.half_length : along;
    const Floats place = low > query.half_length ? Floats{} + query.half_length : low;
    const Floats ex = dx - place * query.ax;
    const Floats ey = dy - place * query.ay;
    const Floats ez = dz - place * query.az;
    const Floats reach = read(query.half_lengths + first) + read(query.margins + first) + query.keep;
    const Bits near = ex * ex + ey * ey + ez * ez <= reach * reach;
    const Index left = end - first;
    std::uint32_t bits = to_bits(near) & (left < width ? (1U << left) - 1U : 0xFFFFU);
    for (; bits != 0; bits &= bits - 1) found[count++] = first + __builtin_ctz(bits);
  }
  return count;
}

}  // namespace fiberfate::FIBERFATE_ISA
