// The smooth orthotropic closure.
#pragma once

#include "base/law_text.hpp"
#include "microstructure/closure_laws/orthotropic.hpp"

namespace fiberfate {

/// A4 in the principal frame as polynomials of 3 terms. Coefficients: eq. 34 of the source.
template <class Math>
struct OrsClosure {
  static constexpr LawText text = {"ors", "Orthotropic smooth: linear in the principal values.",
                                   "Cintra, Tucker, J. Rheol. 39, 1095 (1995)"};
  static constexpr OrthotropicCoefficients coefficients = {
      {-0.15, 1.15, -0.10}, {-0.15, 0.15, 0.90}, {0.60, -0.60, -0.60}};

  [[gnu::always_inline]] static typename Math::Orthotropic components(const typename Math::Frame& frame) {
    return Math::fitted(coefficients, 3, frame);
  }
};

}  // namespace fiberfate
