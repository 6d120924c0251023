// The orthotropic closure fitted to a wide range of interaction coefficients.
#pragma once

#include "base/law_text.hpp"
#include "microstructure/closure_laws/orthotropic.hpp"

namespace fiberfate {

/// A4 in the principal frame as polynomials of 6 terms.
template <class Math>
struct OrwClosure {
  static constexpr LawText text = {"orw", "Orthotropic, fitted to a wide range of C_I, second order.",
                                   "Chung, Kwon, Polym. Compos. 22, 636 (2001)"};
  static constexpr OrthotropicCoefficients coefficients = {
      {0.070055, 0.339376, -0.396796, 0.411944, 0.590331, 0.333693},
      {0.115177, -0.368267, 0.094820, 0.535224, 0.252880, 0.800181},
      {1.249811, -2.148297, -2.290157, 1.934914, 0.898521, 1.044147}};

  [[gnu::always_inline]] static typename Math::Orthotropic components(const typename Math::Frame& frame) {
    return Math::fitted(coefficients, 6, frame);
  }
};

}  // namespace fiberfate
