// Moves vectors of three doubles between memory, where they lie one after the other, and lanes, where they
// lie side by side. For kernels only (base/simd.hpp).
#pragma once

#if defined(FIBERFATE_ISA) && defined(__AVX2__)
#include <immintrin.h>
#endif

#include "base/simd.hpp"

#ifdef FIBERFATE_ISA
namespace fiberfate::FIBERFATE_ISA {

/// Eight vectors by components.
struct Triple {
  Pack x, y, z;
};

static inline __attribute__((always_inline)) Pack dot(const Triple& a, const Triple& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline __attribute__((always_inline)) Triple operator+(const Triple& a, const Triple& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
static inline __attribute__((always_inline)) Triple operator-(const Triple& a, const Triple& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
static inline __attribute__((always_inline)) Triple operator*(const Pack& f, const Triple& v) {
  return {f * v.x, f * v.y, f * v.z};
}

/// Applies a matrix of nine doubles, stored by columns, to eight vectors.
static inline __attribute__((always_inline)) Triple transform(const double* matrix, const Triple& v) {
  return {matrix[0] * v.x + matrix[3] * v.y + matrix[6] * v.z,
          matrix[1] * v.x + matrix[4] * v.y + matrix[7] * v.z,
          matrix[2] * v.x + matrix[5] * v.y + matrix[8] * v.z};
}

#if defined(__AVX512VL__)

// A vector is read as four doubles of which the last is masked: beyond an array's end nothing is touched.
static inline __attribute__((always_inline)) __m512d read_two(const double* low, const double* high) {
  const __m256d a = _mm256_maskz_loadu_pd(7, low);
  const __m256d b = _mm256_maskz_loadu_pd(7, high);
  return _mm512_insertf64x4(_mm512_castpd256_pd512(a), b, 1);
}

/// Reads one vector from each of eight places.
static inline __attribute__((always_inline)) Triple read_triples(const double* const* from) {
  const __m512d a = read_two(from[0], from[4]);
  const __m512d b = read_two(from[1], from[5]);
  const __m512d c = read_two(from[2], from[6]);
  const __m512d d = read_two(from[3], from[7]);
  const __m512d ab_xz = _mm512_unpacklo_pd(a, b);  // of each half: ax bx az bz
  const __m512d ab_y = _mm512_unpackhi_pd(a, b);   // ay by - -
  const __m512d cd_xz = _mm512_unpacklo_pd(c, d);
  const __m512d cd_y = _mm512_unpackhi_pd(c, d);
  const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
  const __m512i high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  return {reinterpret_cast<Pack>(_mm512_permutex2var_pd(ab_xz, low, cd_xz)),
          reinterpret_cast<Pack>(_mm512_permutex2var_pd(ab_y, low, cd_y)),
          reinterpret_cast<Pack>(_mm512_permutex2var_pd(ab_xz, high, cd_xz))};
}

/// Writes one vector to each of eight places.
static inline __attribute__((always_inline)) void write_triples(double* const* to, const Triple& v) {
  const __m512d x = reinterpret_cast<__m512d>(v.x);
  const __m512d y = reinterpret_cast<__m512d>(v.y);
  const __m512d z = reinterpret_cast<__m512d>(v.z);
  const __m512d even = _mm512_unpacklo_pd(x, y);  // x0 y0 x2 y2 x4 y4 x6 y6
  const __m512d odd = _mm512_unpackhi_pd(x, y);   // x1 y1 x3 y3 x5 y5 x7 y7
  const __m512d rows[4] = {_mm512_permutex2var_pd(even, _mm512_setr_epi64(0, 1, 8, 0, 4, 5, 12, 0), z),
                           _mm512_permutex2var_pd(odd, _mm512_setr_epi64(0, 1, 9, 0, 4, 5, 13, 0), z),
                           _mm512_permutex2var_pd(even, _mm512_setr_epi64(2, 3, 10, 0, 6, 7, 14, 0), z),
                           _mm512_permutex2var_pd(odd, _mm512_setr_epi64(2, 3, 11, 0, 6, 7, 15, 0), z)};
  for (int i = 0; i < 4; ++i) {
    _mm256_mask_storeu_pd(to[i], 7, _mm512_castpd512_pd256(rows[i]));
    _mm256_mask_storeu_pd(to[i + 4], 7, _mm512_extractf64x4_pd(rows[i], 1));
  }
}

#else

static inline __attribute__((always_inline)) Triple read_triples(const double* const* from) {
  alignas(64) double lanes_of[3][lanes];
  for (int i = 0; i < lanes; ++i) {
    for (int d = 0; d < 3; ++d) lanes_of[d][i] = from[i][d];
  }
  return {load(lanes_of[0]), load(lanes_of[1]), load(lanes_of[2])};
}

static inline __attribute__((always_inline)) void write_triples(double* const* to, const Triple& v) {
  for (int i = 0; i < lanes; ++i) {
    to[i][0] = v.x[i];
    to[i][1] = v.y[i];
    to[i][2] = v.z[i];
  }
}

#endif

}  // namespace fiberfate::FIBERFATE_ISA
#endif
