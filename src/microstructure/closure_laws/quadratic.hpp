// The quadratic closure.
#pragma once

#include "base/law_text.hpp"

namespace fiberfate {

/// A4 : G = A (A:G).
template <class Math>
struct QuadraticClosure {
  using Number = typename Math::Number;
  using Symmetric = typename Math::Symmetric;

  static constexpr LawText text = {"quadratic", "A2 A2: exact for aligned states.",
                                   "Doi, J. Polym. Sci. B 19, 229 (1981)"};

  [[gnu::always_inline]] static Symmetric contract(const Symmetric& a, const Symmetric& g) {
    return double_dot(a, g) * a;
  }
};

}  // namespace fiberfate
