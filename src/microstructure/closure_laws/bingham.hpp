// The closure of a Bingham distribution.
#pragma once

#include "base/law_text.hpp"
#include "microstructure/closure_laws/orthotropic.hpp"

namespace fiberfate {

/// A4 in the principal frame as polynomials of 10 terms. Coefficients: table II of the source.
template <class Math>
struct BinghamClosure {
  static constexpr LawText text = {"bingham", "As a Bingham distribution, fitted, third order.",
                                   "Chaubal, Leal, J. Rheol. 42, 177 (1998)"};
  static constexpr OrthotropicCoefficients coefficients = {
      {0.412251, 0.896044, -3.44613, 3.24378, -2.02654, 6.13032, 0.381274, -3.22331, 1.71079, -3.7558},
      {0.150497, -0.29378, -0.28173, 0.473044, 0.092542, 1.92763, 0.037776, 0.406202, 0.044353, -1.46408},
      {-0.610534, 5.01094, 4.39396, -15.1093, -8.16518, -6.77247, 10.6866, 9.92054, 3.76426, 2.96854}};

  [[gnu::always_inline]] static typename Math::Orthotropic components(const typename Math::Frame& frame) {
    return Math::fitted(coefficients, 10, frame);
  }
};

}  // namespace fiberfate
