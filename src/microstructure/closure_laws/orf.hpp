// The orthotropic closure fitted to flows of one interaction coefficient.
#pragma once

#include "base/law_text.hpp"
#include "microstructure/closure_laws/orthotropic.hpp"

namespace fiberfate {

/// A4 in the principal frame as polynomials of 6 terms. Coefficients: table VI of the source.
template <class Math>
struct OrfClosure {
  static constexpr LawText text = {"orf", "Orthotropic, fitted to flows of C_I = 0.01.",
                                   "Cintra, Tucker, J. Rheol. 39, 1095 (1995)"};
  static constexpr OrthotropicCoefficients coefficients = {
      {0.060964, 0.371243, -0.369160, 0.371218, 0.555301, 0.318266},
      {0.124711, -0.389402, 0.086169, 0.544992, 0.258844, 0.796080},
      {1.228982, -2.054116, -2.260574, 1.819756, 0.821548, 1.053907}};

  [[gnu::always_inline]] static typename Math::Orthotropic components(const typename Math::Frame& frame) {
    return Math::fitted(coefficients, 6, frame);
  }
};

}  // namespace fiberfate
