// The orthotropic closure of third order, fitted to a wide range of interaction coefficients.
#pragma once

#include "base/law_text.hpp"
#include "microstructure/closure_laws/orthotropic.hpp"

namespace fiberfate {

/// A4 in the principal frame as polynomials of 10 terms.
template <class Math>
struct Orw3Closure {
  static constexpr LawText text = {"orw3", "Orthotropic, fitted to a wide range of C_I, third order.",
                                   "Chung, Kwon, Polym. Compos. 22, 636 (2001)"};
  static constexpr OrthotropicCoefficients coefficients = {
      {-0.1480648093, 0.8084618453, 0.7765597096, -1.7366749542, 0.3722003446, -1.3431772379, 0.8895946393,
       1.7367571741, -0.0324756095, 0.6631716575},
      {-0.2106349673, 0.9092350296, 1.1104441966, -2.5375632310, -1.2840654776, 0.1260059291, 1.9988098293,
       1.4863151577, 0.5856304774, -0.0756740034},
      {0.4868019601, 0.5776328438, 0.4605743789, -4.8900459209, -2.2462007509, -1.9088154281, 4.0544348937,
       3.8542602127, 1.1817992322, 0.9512305286}};

  [[gnu::always_inline]] static typename Math::Orthotropic components(const typename Math::Frame& frame) {
    return Math::fitted(coefficients, 10, frame);
  }
};

}  // namespace fiberfate
