// The invariant-based optimal fitting of A4.
#pragma once

#include "base/law_text.hpp"

namespace fiberfate {

/// A4 as the symmetric parts of I I, I A, A A, I A·A, A A·A, A·A A·A with coefficients beta_1 to beta_6, of
/// which beta_3, beta_4, beta_6 are polynomials of the invariants II and III and the others keep A4
/// normalised. Source: Chung, Kwon, J. Rheol. 46, 169 (2002), eqs. 18 to 22, table I, digit for digit.
template <class Math>
struct IbofClosure {
  using Number = typename Math::Number;
  using Symmetric = typename Math::Symmetric;

  static constexpr LawText text = {"ibof",
                                   "Invariant-based optimal fitting: accurate and without eigenvectors.",
                                   "Chung, Kwon, J. Rheol. 46, 169 (2002)"};
  static constexpr int terms = 21;
  static constexpr double coefficients[3][terms] = {
      {0.24940908165786e2,   -0.435101153160329e3, 0.372389335663877e4,  0.703443657916476e4,
       0.823995187366106e6,  -0.133931929894245e6, 0.880683515327916e6,  -0.991630690741981e7,
       -0.159392396237307e5, 0.800970026849796e7,  -0.237010458689252e7, 0.379010599355267e8,
       -0.337010820273821e8, 0.322219416256417e5,  -0.257258805870567e9, 0.214419090344474e7,
       -0.449275591851490e8, -0.213133920223355e8, 0.157076702372204e10, -0.232153488525298e5,
       -0.395769398304473e10},
      {-0.497217790110754e0, 0.234980797511405e2,  -0.391044251397838e3, 0.153965820593506e3,
       0.152772950743819e6,  -0.213755248785646e4, -0.400138947092812e4, -0.185949305922308e7,
       0.296004865275814e4,  0.247717810054366e7,  0.101013983339062e6,  0.732341494213578e7,
       -0.147919027644202e8, -0.104092072189767e5, -0.635149929624336e8, -0.247435106210237e6,
       -0.902980378929272e7, 0.724969796807399e7,  0.487093452892595e9,  0.138088690964946e5,
       -0.160162178614234e10},
      {0.234146291570999e2,  -0.412048043372534e3,  0.319553200392089e4,   0.573259594331015e4,
       -0.485212803064813e5, -0.605006113515592e5,  -0.477173740017567e5,  0.599066486689836e7,
       -0.110656935176569e5, -0.460543580680696e8,  0.203042960322874e7,   -0.556606156734835e8,
       0.567424911007837e9,  0.128967058686204e5,   -0.152752854956514e10, -0.499321746092534e7,
       0.132124828143333e9,  -0.162359994620983e10, 0.792526849882218e10,  0.466767581292985e4,
       -0.128050778279459e11}};

  struct Betas {
    Number b1, b2, b3, b4, b5, b6;
  };

  [[gnu::always_inline]] static Betas betas(const Symmetric& a) {
    const Number x =
        a.c11 * a.c22 + a.c22 * a.c33 + a.c33 * a.c11 - a.c12 * a.c12 - a.c23 * a.c23 - a.c31 * a.c31;
    const Number y = determinant(a);
    const Number x2 = x * x, x3 = x2 * x, x4 = x2 * x2, y2 = y * y, y3 = y2 * y, y4 = y2 * y2;
    const Number power[terms] = {
        Math::number(1), x,      x2, y,  y2,     x * y,   x2 * y,  x * y2, x3,     y3,    x3 * y,
        x2 * y2,         x * y3, x4, y4, x4 * y, x3 * y2, x2 * y3, x * y4, x4 * x, y4 * y};
    Number b[3];
    for (int k = 0; k < 3; ++k) {
      b[k] = Math::number(0);
      for (int i = 0; i < terms; ++i) b[k] = b[k] + coefficients[k][i] * power[i];
    }
    const Number b3 = b[0], b4 = b[1], b6 = b[2];
    const Number b1 =
        0.6 * (-1.0 / 7 + 0.2 * b3 * (1.0 / 7 + 4.0 / 7 * x + 8.0 / 3 * y) -
               b4 * (0.2 - 8.0 / 15 * x - 14.0 / 15 * y) -
               b6 * (1.0 / 35 - 24.0 / 105 * y - 4.0 / 35 * x + 16.0 / 15 * x * y + 8.0 / 35 * x2));
    const Number b2 = 6.0 / 7 *
                      (1.0 - 0.2 * b3 * (1.0 + 4.0 * x) + 1.4 * b4 * (1.0 / 6 - x) -
                       b6 * (-0.2 + 2.0 / 3 * y + 0.8 * x - 1.6 * x2));
    const Number b5 = -0.8 * b3 - 1.4 * b4 - 1.2 * b6 * (1.0 - 4.0 / 3 * x);
    return {b1, b2, b3, b4, b5, b6};
  }

  [[gnu::noinline]] static Symmetric contract(const Symmetric& a, const Symmetric& g) {
    const Betas b = betas(a);
    const Symmetric q = square(a);
    const Symmetric s = sandwich(a, g);
    const Number ag = double_dot(a, g), qg = double_dot(q, g);
    Symmetric sum = (b.b1 / 3.0) * (Math::isotropic(trace(g)) + 2.0 * g);
    sum = sum + (b.b2 / 6.0) * identity_term(a, ag, g);
    sum = sum + (b.b3 / 3.0) * (ag * a + 2.0 * s);
    sum = sum + (b.b4 / 6.0) * identity_term(q, qg, g);
    sum = sum + (b.b5 / 6.0) * (qg * a + ag * q + 2.0 * anticommutator(s, a));
    return sum + (b.b6 / 3.0) * (qg * q + 2.0 * sandwich(a, s));
  }
};

}  // namespace fiberfate
