// Closes eight orientation states side by side: contracts A4(A2) with a symmetric tensor; only kernels
// include it.
#pragma once

#include "base/pack_math.hpp"
#include "microstructure/closure_kind.hpp"
#include "microstructure/closure_laws/closure_laws.hpp"
#include "microstructure/eigenframe_pack.hpp"
#include "microstructure/exact_closure.hpp"

#ifdef FIBERFATE_ISA
namespace fiberfate::FIBERFATE_ISA {

/// A_1111, A_2222, A_3333, A_2233, A_3311, A_1122 of a fully symmetric orthotropic A4 in its principal
/// frame.
struct Orthotropic {
  Pack c1, c2, c3, c23, c31, c12;
};

/// Symmetric part of I A : G times 6: I (A:G) + A tr G + 2 (A·G + G·A).
FIBERFATE_INLINE Symmetric identity_term(const Symmetric& a, const Pack& dot, const Symmetric& g) {
  const Symmetric product = anticommutator(a, g);
  return isotropic(dot) + trace(g) * a + 2.0 * product;
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

/// Evaluates a fit (closure_laws/orthotropic.hpp); `terms` of its powers are not zero.
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

FIBERFATE_OUT_OF_LINE Orthotropic exact_fourth(const Frame& frame) {
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

/// The arithmetic that kernels offer to closures.
struct ClosureMath : PackMath {
  using Symmetric = FIBERFATE_ISA::Symmetric;
  using Frame = FIBERFATE_ISA::Frame;
  using Orthotropic = FIBERFATE_ISA::Orthotropic;

  [[gnu::always_inline]] static Symmetric isotropic(const Pack& a) { return FIBERFATE_ISA::isotropic(a); }
  [[gnu::always_inline]] static Orthotropic fitted(const OrthotropicCoefficients& coefficients, int terms,
                                                   const Frame& frame) {
    return FIBERFATE_ISA::fitted(coefficients, terms, frame);
  }
  [[gnu::always_inline]] static Orthotropic exact(const Frame& frame) { return exact_fourth(frame); }
};

/// Whether a closure gives components in the principal frame, rather than the contraction itself.
template <class Law>
inline constexpr bool closes_in_frame = requires {
  &Law::components;
};

FIBERFATE_INLINE bool needs_frame(Closure closure) {
  return visit_law<bool, ClosureMath, ClosureLaws>(static_cast<int>(closure),
                                                   [](auto law) { return closes_in_frame<decltype(law)>; });
}

/// A4 in its principal frame, of a closure that gives it there.
FIBERFATE_INLINE Orthotropic orthotropic_components(Closure closure, const Frame& frame) {
  return visit_law<Orthotropic, ClosureMath, ClosureLaws>(
      static_cast<int>(closure), [&](auto law) __attribute__((always_inline))->Orthotropic {
        if constexpr (closes_in_frame<decltype(law)>) return decltype(law)::components(frame);
        __builtin_unreachable();
      });
}

FIBERFATE_INLINE Symmetric contract_orthotropic(const Orthotropic& c, const Frame& frame,
                                                const Symmetric& g) {
  const Symmetric x = into_frame(frame, g);
  return out_of_frame(
      frame, {c.c1 * x.c11 + c.c12 * x.c22 + c.c31 * x.c33, c.c12 * x.c11 + c.c2 * x.c22 + c.c23 * x.c33,
              c.c31 * x.c11 + c.c23 * x.c22 + c.c3 * x.c33, 2.0 * c.c23 * x.c23, 2.0 * c.c31 * x.c31,
              2.0 * c.c12 * x.c12});
}

/// A4(A2) : G. The frame is read only where needs_frame(closure).
FIBERFATE_INLINE Symmetric contract_closure(Closure closure, const Symmetric& a, const Frame& frame,
                                            const Symmetric& g) {
  if (needs_frame(closure)) return contract_orthotropic(orthotropic_components(closure, frame), frame, g);
  return visit_law<Symmetric, ClosureMath, ClosureLaws>(
      static_cast<int>(closure), [&](auto law) __attribute__((always_inline))->Symmetric {
        if constexpr (!closes_in_frame<decltype(law)>) return decltype(law)::contract(a, g);
        __builtin_unreachable();
      });
}

}  // namespace fiberfate::FIBERFATE_ISA
#endif
