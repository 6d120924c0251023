// Computes with symmetric tensors of eight points side by side; only kernels include it.
#pragma once

#include "base/simd.hpp"

#ifdef FIBERFATE_ISA
#define FIBERFATE_INLINE static inline __attribute__((always_inline))
/// Marks what is long and called from several places: inlined everywhere it would take minutes to compile.
#define FIBERFATE_OUT_OF_LINE static inline __attribute__((noinline))

namespace fiberfate::FIBERFATE_ISA {

/// The components 11, 22, 33, 23, 31, 12 of eight symmetric tensors.
struct Symmetric {
  Pack c11, c22, c33, c23, c31, c12;
};

/// W12, W23, W31 of eight antisymmetric tensors.
struct Antisymmetric {
  Pack c12, c23, c31;
};

FIBERFATE_INLINE Symmetric isotropic(const Pack& a) {
  const Pack zero = broadcast(0);
  return {a, a, a, zero, zero, zero};
}

FIBERFATE_INLINE Symmetric operator+(const Symmetric& a, const Symmetric& b) {
  return {a.c11 + b.c11, a.c22 + b.c22, a.c33 + b.c33, a.c23 + b.c23, a.c31 + b.c31, a.c12 + b.c12};
}

FIBERFATE_INLINE Symmetric operator-(const Symmetric& a, const Symmetric& b) {
  return {a.c11 - b.c11, a.c22 - b.c22, a.c33 - b.c33, a.c23 - b.c23, a.c31 - b.c31, a.c12 - b.c12};
}

FIBERFATE_INLINE Symmetric operator*(const Pack& s, const Symmetric& a) {
  return {s * a.c11, s * a.c22, s * a.c33, s * a.c23, s * a.c31, s * a.c12};
}

FIBERFATE_INLINE Symmetric operator*(double s, const Symmetric& a) {
  return broadcast(s) * a;
}

FIBERFATE_INLINE Pack trace(const Symmetric& a) {
  return a.c11 + a.c22 + a.c33;
}

FIBERFATE_INLINE Pack double_dot(const Symmetric& a, const Symmetric& b) {
  const Pack off = a.c23 * b.c23 + a.c31 * b.c31 + a.c12 * b.c12;
  return a.c11 * b.c11 + a.c22 * b.c22 + a.c33 * b.c33 + off + off;
}

FIBERFATE_INLINE Pack determinant(const Symmetric& a) {
  return a.c11 * (a.c22 * a.c33 - a.c23 * a.c23) - a.c12 * (a.c12 * a.c33 - a.c23 * a.c31) +
         a.c31 * (a.c12 * a.c23 - a.c22 * a.c31);
}

/// A · A.
FIBERFATE_INLINE Symmetric square(const Symmetric& a) {
  return {a.c11 * a.c11 + a.c12 * a.c12 + a.c31 * a.c31, a.c12 * a.c12 + a.c22 * a.c22 + a.c23 * a.c23,
          a.c31 * a.c31 + a.c23 * a.c23 + a.c33 * a.c33, a.c12 * a.c31 + a.c22 * a.c23 + a.c23 * a.c33,
          a.c31 * a.c11 + a.c23 * a.c12 + a.c33 * a.c31, a.c11 * a.c12 + a.c12 * a.c22 + a.c31 * a.c23};
}

/// A · B + B · A.
FIBERFATE_INLINE Symmetric anticommutator(const Symmetric& a, const Symmetric& b) {
  const Pack p11 = a.c11 * b.c11 + a.c12 * b.c12 + a.c31 * b.c31;
  const Pack p22 = a.c12 * b.c12 + a.c22 * b.c22 + a.c23 * b.c23;
  const Pack p33 = a.c31 * b.c31 + a.c23 * b.c23 + a.c33 * b.c33;
  const Pack p23 =
      a.c12 * b.c31 + a.c22 * b.c23 + a.c23 * b.c33 + a.c31 * b.c12 + a.c23 * b.c22 + a.c33 * b.c23;
  const Pack p31 =
      a.c31 * b.c11 + a.c23 * b.c12 + a.c33 * b.c31 + a.c11 * b.c31 + a.c12 * b.c23 + a.c31 * b.c33;
  const Pack p12 =
      a.c11 * b.c12 + a.c12 * b.c22 + a.c31 * b.c23 + a.c12 * b.c11 + a.c22 * b.c12 + a.c23 * b.c31;
  return {p11 + p11, p22 + p22, p33 + p33, p23, p31, p12};
}

/// A · G · A.
FIBERFATE_INLINE Symmetric sandwich(const Symmetric& a, const Symmetric& g) {
  const Pack t11 = g.c11 * a.c11 + g.c12 * a.c12 + g.c31 * a.c31;  // T = G · A
  const Pack t12 = g.c11 * a.c12 + g.c12 * a.c22 + g.c31 * a.c23;
  const Pack t13 = g.c11 * a.c31 + g.c12 * a.c23 + g.c31 * a.c33;
  const Pack t21 = g.c12 * a.c11 + g.c22 * a.c12 + g.c23 * a.c31;
  const Pack t22 = g.c12 * a.c12 + g.c22 * a.c22 + g.c23 * a.c23;
  const Pack t23 = g.c12 * a.c31 + g.c22 * a.c23 + g.c23 * a.c33;
  const Pack t31 = g.c31 * a.c11 + g.c23 * a.c12 + g.c33 * a.c31;
  const Pack t32 = g.c31 * a.c12 + g.c23 * a.c22 + g.c33 * a.c23;
  const Pack t33 = g.c31 * a.c31 + g.c23 * a.c23 + g.c33 * a.c33;
  return {a.c11 * t11 + a.c12 * t21 + a.c31 * t31, a.c12 * t12 + a.c22 * t22 + a.c23 * t32,
          a.c31 * t13 + a.c23 * t23 + a.c33 * t33, a.c12 * t13 + a.c22 * t23 + a.c23 * t33,
          a.c31 * t11 + a.c23 * t21 + a.c33 * t31, a.c11 * t12 + a.c12 * t22 + a.c31 * t32};
}

/// W · A - A · W.
FIBERFATE_INLINE Symmetric spin(const Antisymmetric& w, const Symmetric& a) {
  const Pack b11 = w.c12 * a.c12 - w.c31 * a.c31;  // B = W · A; the result is B + Bᵀ
  const Pack b22 = w.c23 * a.c23 - w.c12 * a.c12;
  const Pack b33 = w.c31 * a.c31 - w.c23 * a.c23;
  return {b11 + b11,
          b22 + b22,
          b33 + b33,
          w.c23 * (a.c33 - a.c22) + w.c31 * a.c12 - w.c12 * a.c31,
          w.c31 * (a.c11 - a.c33) + w.c12 * a.c23 - w.c23 * a.c12,
          w.c12 * (a.c22 - a.c11) + w.c23 * a.c31 - w.c31 * a.c23};
}

}  // namespace fiberfate::FIBERFATE_ISA
#endif
