// The hybrid closure.
#pragma once

#include "base/law_text.hpp"
#include "microstructure/closure_laws/linear.hpp"
#include "microstructure/closure_laws/quadratic.hpp"

namespace fiberfate {

/// f quadratic + (1 - f) linear, f = 1 - 27 det A.
template <class Math>
struct HybridClosure {
  using Number = typename Math::Number;
  using Symmetric = typename Math::Symmetric;

  static constexpr LawText text = {"hybrid",
                                   "Linear and quadratic mixed by 1 - 27 det A2; overestimates alignment.",
                                   "Advani, Tucker, J. Rheol. 34, 367 (1990)"};

  [[gnu::always_inline]] static Symmetric contract(const Symmetric& a, const Symmetric& g) {
    const Number linear = 27.0 * determinant(a);
    return linear * LinearClosure<Math>::contract(a, g) +
           (1.0 - linear) * QuadraticClosure<Math>::contract(a, g);
  }
};

}  // namespace fiberfate
