// The peaked orthotropic closure.
#pragma once

#include "base/law_text.hpp"
#include "microstructure/closure_laws/orthotropic.hpp"

namespace fiberfate {

/// A4 in the principal frame as polynomials of 3 terms.
template <class Math>
struct OrpClosure {
  static constexpr LawText text = {"orp", "Orthotropic peaked: all fibers along the principal axes.",
                                   "Cintra, Tucker, J. Rheol. 39, 1095 (1995)"};
  static constexpr OrthotropicCoefficients coefficients = {{0, 1, 0}, {0, 0, 1}, {1, -1, -1}};

  [[gnu::always_inline]] static typename Math::Orthotropic components(const typename Math::Frame& frame) {
    return Math::fitted(coefficients, 3, frame);
  }
};

}  // namespace fiberfate
