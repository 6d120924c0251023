// Arithmetic of eight doubles side by side, in which kernels evaluate the laws of forces (base/law_math.hpp).
// For kernels only (base/simd.hpp).
#pragma once

#include "base/simd.hpp"

#ifdef FIBERFATE_ISA
namespace fiberfate::FIBERFATE_ISA {

/// arcsin(h)/h for y = h² in [0, 1]: the rational approximation of the C library (Sun fdlibm, e_asin.c) up to
/// h = 1/2, beyond by arcsin(h) = pi/2 − 2 arcsin sqrt((1 − h)/2).
static inline __attribute__((always_inline)) Pack arcsine_ratio_below_half(const Pack& y) {
  const Pack p = y * (1.66666666666666657415e-01 +
                      y * (-3.25565818622400915405e-01 +
                           y * (2.01212532134862925881e-01 +
                                y * (-4.00555345006794114027e-02 +
                                     y * (7.91534994289814532176e-04 + y * 3.47933107596021167570e-05)))));
  const Pack q = 1.0 + y * (-2.40339491173441421878e+00 +
                            y * (2.02094576023350569471e+00 +
                                 y * (-6.88283971605453293030e-01 + y * 7.70381505559019352791e-02)));
  return 1.0 + p / q;
}
static inline __attribute__((always_inline)) Pack arcsine_ratio_of(const Pack& y) {
  const Mask sharp = y > 0.25;
  if (to_bits(sharp) == 0) return arcsine_ratio_below_half(y);
  const Pack h = square_root(y);
  const Pack z = 0.5 * (1.0 - h);
  const Pack ratio = arcsine_ratio_below_half(choose(sharp, z, y));
  const Pack folded = (1.57079632679489661923 - 2.0 * square_root(z) * ratio) / h;
  return choose(sharp, folded, ratio);
}

struct PackMath {
  using Number = Pack;

  [[gnu::always_inline]] static Pack number(double x) { return broadcast(x); }
  [[gnu::always_inline]] static Pack choose(const Mask& mask, const Pack& yes, const Pack& no) {
    return mask ? yes : no;
  }
  [[gnu::always_inline]] static Pack smaller(const Pack& a, const Pack& b) { return a < b ? a : b; }
  [[gnu::always_inline]] static Pack larger(const Pack& a, const Pack& b) { return a > b ? a : b; }
  [[gnu::always_inline]] static Pack square_root(const Pack& x) { return FIBERFATE_ISA::square_root(x); }
  [[gnu::always_inline]] static Pack exponential(const Pack& x) { return exponential_of(x); }
  [[gnu::always_inline]] static Pack arcsine_ratio(const Pack& y) { return arcsine_ratio_of(y); }
};

/// How many constants a law of PackMath has.
template <class Law>
inline constexpr int constants_of = __is_empty(Law) ? 0 : static_cast<int>(sizeof(Law) / sizeof(Pack));

/// Makes a law that has the same constants in all lanes; they come in the order of its members.
template <class Law>
[[gnu::always_inline]] inline Law same_law(const double* constants) {
  Law law{};
  for (int i = 0; i < constants_of<Law>; ++i) reinterpret_cast<Pack*>(&law)[i] = broadcast(constants[i]);
  return law;
}

/// Gives one lane of a law constants of its own.
template <class Law>
[[gnu::always_inline]] inline void set_lane(Law& law, int lane, const double* constants) {
  for (int i = 0; i < constants_of<Law>; ++i) reinterpret_cast<Pack*>(&law)[i][lane] = constants[i];
}

}  // namespace fiberfate::FIBERFATE_ISA
#endif
