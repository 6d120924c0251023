// Closes eight orientation states side by side: contracts A4(A2) with a symmetric tensor; only kernels
// include it.
#pragma once

#include "microstructure/closure_coefficients.hpp"
#include "microstructure/closure_kind.hpp"
#include "microstructure/eigenframe_pack.hpp"
#include "microstructure/exact_closure.hpp"

#ifdef FIBERFATE_ISA
namespace fiberfate::FIBERFATE_ISA {

/// A_1111, A_2222, A_3333, A_2233, A_3311, A_1122 of a fully symmetric orthotropic A4 in its principal
/// frame.
struct Orthotropic {
  Pack c1, c2, c3, c23, c31, c12;
};

FIBERFATE_INLINE bool needs_frame(Closure closure) {
  return closure >= Closure::orf;
}

/// Symmetric part of I A : G times 6: I (A:G) + A tr G + 2 (A·G + G·A).
FIBERFATE_INLINE Symmetric identity_term(const Symmetric& a, const Pack& dot, const Symmetric& g) {
  const Symmetric product = anticommutator(a, g);
  return isotropic(dot) + trace(g) * a + 2.0 * product;
}

/// A4 : G = -1/35 (I tr G + 2 G) + 1/7 (I A:G + A tr G + 2 (A·G + G·A)). Advani, Tucker, J. Rheol. 31, 751
/// (1987).
FIBERFATE_INLINE Symmetric contract_linear(const Symmetric& a, const Symmetric& g) {
  return (1.0 / 7) * identity_term(a, double_dot(a, g), g) - (1.0 / 35) * (isotropic(trace(g)) + 2.0 * g);
}

/// A4 : G = A (A:G). Doi, J. Polym. Sci. B 19, 229 (1981).
FIBERFATE_INLINE Symmetric contract_quadratic(const Symmetric& a, const Symmetric& g) {
  return double_dot(a, g) * a;
}

/// f quadratic + (1 - f) linear, f = 1 - 27 det A. Advani, Tucker, J. Rheol. 34, 367 (1990).
FIBERFATE_INLINE Symmetric contract_hybrid(const Symmetric& a, const Symmetric& g) {
  const Pack linear = 27.0 * determinant(a);
  return linear * contract_linear(a, g) + (1.0 - linear) * contract_quadratic(a, g);
}

struct IbofBetas {
  Pack b1, b2, b3, b4, b5, b6;
};

/// Coefficients of the six basis tensors of IBOF. Chung, Kwon, J. Rheol. 46, 169 (2002), eqs. 18 to 22.
FIBERFATE_INLINE IbofBetas ibof_betas(const Symmetric& a) {
  const Pack x =
      a.c11 * a.c22 + a.c22 * a.c33 + a.c33 * a.c11 - a.c12 * a.c12 - a.c23 * a.c23 - a.c31 * a.c31;
  const Pack y = determinant(a);
  const Pack x2 = x * x, x3 = x2 * x, x4 = x2 * x2, y2 = y * y, y3 = y2 * y, y4 = y2 * y2;
  const Pack power[ibof_terms] = {broadcast(1), x,      x2,      y,       y2,      x * y,  x2 * y,
                                  x * y2,       x3,     y3,      x3 * y,  x2 * y2, x * y3, x4,
                                  y4,           x4 * y, x3 * y2, x2 * y3, x * y4,  x4 * x, y4 * y};
  Pack b[3];
  for (int k = 0; k < 3; ++k) {
    b[k] = broadcast(0);
    for (int i = 0; i < ibof_terms; ++i) b[k] = b[k] + ibof_coefficients[k][i] * power[i];
  }
  const Pack b3 = b[0], b4 = b[1], b6 = b[2];
  const Pack b1 = 0.6 * (-1.0 / 7 + 0.2 * b3 * (1.0 / 7 + 4.0 / 7 * x + 8.0 / 3 * y) -
                         b4 * (0.2 - 8.0 / 15 * x - 14.0 / 15 * y) -
                         b6 * (1.0 / 35 - 24.0 / 105 * y - 4.0 / 35 * x + 16.0 / 15 * x * y + 8.0 / 35 * x2));
  const Pack b2 = 6.0 / 7 *
                  (1.0 - 0.2 * b3 * (1.0 + 4.0 * x) + 1.4 * b4 * (1.0 / 6 - x) -
                   b6 * (-0.2 + 2.0 / 3 * y + 0.8 * x - 1.6 * x2));
  const Pack b5 = -0.8 * b3 - 1.4 * b4 - 1.2 * b6 * (1.0 - 4.0 / 3 * x);
  return {b1, b2, b3, b4, b5, b6};
}

FIBERFATE_OUT_OF_LINE Symmetric contract_ibof(const Symmetric& a, const Symmetric& g) {
  const IbofBetas b = ibof_betas(a);
  const Symmetric q = square(a);
  const Symmetric s = sandwich(a, g);
  const Pack ag = double_dot(a, g), qg = double_dot(q, g);
  Symmetric sum = (b.b1 / 3.0) * (isotropic(trace(g)) + 2.0 * g);
  sum = sum + (b.b2 / 6.0) * identity_term(a, ag, g);
  sum = sum + (b.b3 / 3.0) * (ag * a + 2.0 * s);
  sum = sum + (b.b4 / 6.0) * identity_term(q, qg, g);
  sum = sum + (b.b5 / 6.0) * (qg * a + ag * q + 2.0 * anticommutator(s, a));
  return sum + (b.b6 / 3.0) * (qg * q + 2.0 * sandwich(a, s));
}

/// Completes A_1111, A_2222, A_3333 with the normalisation A_iikk = A_ii.
FIBERFATE_INLINE Orthotropic completed(const Pack (&value)[3], const Pack& c1, const Pack& c2,
                                       const Pack& c3) {
  const Pack r1 = value[0] - c1, r2 = value[1] - c2, r3 = value[2] - c3;
  return {c1, c2, c3, 0.5 * (r2 + r3 - r1), 0.5 * (r3 + r1 - r2), 0.5 * (r1 + r2 - r3)};
}

/// Averages over the rotations that leave A2 as it is where principal values are equal: the fits favour one
/// of the axes there, which would make the answer depend on the frame of the computation.
FIBERFATE_INLINE Orthotropic averaged_over_equal(const Orthotropic& a, const EqualPairs& equal) {
  const Pack around_1 = 0.375 * (a.c2 + a.c3) + 0.75 * a.c23;
  const Pack around_3 = 0.375 * (a.c1 + a.c2) + 0.75 * a.c12;
  const Pack mean_1 = 0.5 * (a.c12 + a.c31);
  const Pack mean_3 = 0.5 * (a.c23 + a.c31);
  Orthotropic b = a;
  b.c2 = choose(equal.p23, around_1, b.c2);
  b.c3 = choose(equal.p23, around_1, b.c3);
  b.c23 = choose(equal.p23, around_1 / 3.0, b.c23);
  b.c12 = choose(equal.p23, mean_1, b.c12);
  b.c31 = choose(equal.p23, mean_1, b.c31);
  b.c1 = choose(equal.p12, around_3, b.c1);
  b.c2 = choose(equal.p12, around_3, b.c2);
  b.c12 = choose(equal.p12, around_3 / 3.0, b.c12);
  b.c23 = choose(equal.p12, mean_3, b.c23);
  b.c31 = choose(equal.p12, mean_3, b.c31);
  const Pack fifth = broadcast(1.0 / 5), fifteenth = broadcast(1.0 / 15);
  return {choose(equal.p31, fifth, b.c1),      choose(equal.p31, fifth, b.c2),
          choose(equal.p31, fifth, b.c3),      choose(equal.p31, fifteenth, b.c23),
          choose(equal.p31, fifteenth, b.c31), choose(equal.p31, fifteenth, b.c12)};
}

/// Evaluates one of the fits of closure_coefficients.hpp; `terms` of its powers are not zero.
FIBERFATE_OUT_OF_LINE Orthotropic fitted(const OrthotropicCoefficients& coefficients, int terms,
                                         const Frame& frame) {
  const Pack x = frame.value[0], y = frame.value[1];
  const Pack x2 = x * x, y2 = y * y;
  const Pack power[orthotropic_terms] = {broadcast(1), x,          y,          x * y,   x2,
                                         y2,           x2 * y,     x * y2,     x2 * x,  y2 * y,
                                         x2 * y2,      x2 * x * y, x * y2 * y, x2 * x2, y2 * y2};
  Pack c[3];
  for (int k = 0; k < 3; ++k) {
    c[k] = broadcast(0);
    for (int i = 0; i < terms; ++i) c[k] = c[k] + coefficients[k][i] * power[i];
  }
  return averaged_over_equal(completed(frame.value, c[0], c[1], c[2]),
                             equal_pairs(frame.value, broadcast(equal_values)));
}

FIBERFATE_OUT_OF_LINE Orthotropic exact_components(const Frame& frame) {
  Orthotropic a;
  for (int i = 0; i < lanes; ++i) {
    const double values[3] = {frame.value[0][i], frame.value[1][i], frame.value[2][i]};
    double c[6];
    close_exactly(values, c);
    a.c1[i] = c[0];
    a.c2[i] = c[1];
    a.c3[i] = c[2];
    a.c23[i] = c[3];
    a.c31[i] = c[4];
    a.c12[i] = c[5];
  }
  return averaged_over_equal(a, equal_pairs(frame.value, broadcast(equal_values)));
}

FIBERFATE_INLINE Orthotropic orthotropic_components(Closure closure, const Frame& frame) {
  switch (closure) {
    case Closure::orf:
      return fitted(orf_coefficients, 6, frame);
    case Closure::orw:
      return fitted(orw_coefficients, 6, frame);
    case Closure::orw3:
      return fitted(orw3_coefficients, 10, frame);
    case Closure::ors:
      return fitted(ors_coefficients, 3, frame);
    case Closure::orl:
      return fitted(orl_coefficients, 6, frame);
    case Closure::orp:
      return fitted(orp_coefficients, 3, frame);
    case Closure::bingham:
      return fitted(bingham_coefficients, 10, frame);
    case Closure::exact:
      return exact_components(frame);
    default:
      return fitted(ore_coefficients, orthotropic_terms, frame);
  }
}

FIBERFATE_INLINE Symmetric contract_orthotropic(Closure closure, const Frame& frame, const Symmetric& g) {
  const Orthotropic a = orthotropic_components(closure, frame);
  const Symmetric x = into_frame(frame, g);
  return out_of_frame(
      frame, {a.c1 * x.c11 + a.c12 * x.c22 + a.c31 * x.c33, a.c12 * x.c11 + a.c2 * x.c22 + a.c23 * x.c33,
              a.c31 * x.c11 + a.c23 * x.c22 + a.c3 * x.c33, 2.0 * a.c23 * x.c23, 2.0 * a.c31 * x.c31,
              2.0 * a.c12 * x.c12});
}

/// A4(A2) : G. The frame is read only where needs_frame(closure).
FIBERFATE_INLINE Symmetric contract_closure(Closure closure, const Symmetric& a, const Frame& frame,
                                            const Symmetric& g) {
  switch (closure) {
    case Closure::linear:
      return contract_linear(a, g);
    case Closure::quadratic:
      return contract_quadratic(a, g);
    case Closure::hybrid:
      return contract_hybrid(a, g);
    case Closure::ibof:
      return contract_ibof(a, g);
    default:
      return contract_orthotropic(closure, frame, g);
  }
}

}  // namespace fiberfate::FIBERFATE_ISA
#endif
