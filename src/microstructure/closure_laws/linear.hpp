// The linear closure.
#pragma once

#include "base/law_text.hpp"

namespace fiberfate {

/// A4 : G = -1/35 (I tr G + 2 G) + 1/7 (I A:G + A tr G + 2 (A·G + G·A)).
template <class Math>
struct LinearClosure {
  using Number = typename Math::Number;
  using Symmetric = typename Math::Symmetric;

  static constexpr LawText text = {"linear", "Linear in A2: exact for isotropic states, unstable in flow.",
                                   "Advani, Tucker, J. Rheol. 31, 751 (1987)"};

  [[gnu::always_inline]] static Symmetric contract(const Symmetric& a, const Symmetric& g) {
    return (1.0 / 7) * identity_term(a, double_dot(a, g), g) -
           (1.0 / 35) * (Math::isotropic(trace(g)) + 2.0 * g);
  }
};

}  // namespace fiberfate
