// The orthotropic closure fitted to flows of low interaction coefficients.
#pragma once

#include "base/law_text.hpp"
#include "microstructure/closure_laws/orthotropic.hpp"

namespace fiberfate {

/// A4 in the principal frame as polynomials of 6 terms. Coefficients: table VII of the source.
template <class Math>
struct OrlClosure {
  static constexpr LawText text = {"orl", "Orthotropic, fitted to flows of low C_I.",
                                   "Cintra, Tucker, J. Rheol. 39, 1095 (1995)"};
  static constexpr OrthotropicCoefficients coefficients = {
      {0.104753, 0.346874, -0.563168, 0.491202, 0.544970, 0.471144},
      {0.162210, -0.451257, -0.028702, 0.652712, 0.286639, 0.864008},
      {1.288896, -2.187810, -2.402857, 1.975826, 0.899635, 1.133547}};

  [[gnu::always_inline]] static typename Math::Orthotropic components(const typename Math::Frame& frame) {
    return Math::fitted(coefficients, 6, frame);
  }
};

}  // namespace fiberfate
