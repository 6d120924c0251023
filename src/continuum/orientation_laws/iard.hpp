// Rotary diffusion that the flow suppresses along its stretching.
#pragma once

#include "base/law_text.hpp"
#include "continuum/orientation_constants.hpp"

namespace fiberfate {

/// C = C_I (I - C_M D²/|D²|), |X| = sqrt(X:X/2).
template <class Math>
struct IardDiffusion {
  static constexpr LawText text = {
      "iard",
      "C = C_I (I - C_M D²/|D²|), |X| = sqrt(X:X/2); indefinite in uniaxial flow for C_M > 3/4.",
      "Tseng, Chang, Hsu, J. Rheol. 60, 215 (2016)",
      {"C_I", "C_M"}};
  static constexpr bool depends_on_orientation = false;

  [[gnu::always_inline]] static typename Math::Diffusion diffusion(const OrientationConstants& c,
                                                                   const typename Math::Place& at) {
    using Number = typename Math::Number;
    const typename Math::Symmetric n2 = square(at.unit_strain);
    const Number size = Math::square_root(0.5 * double_dot(n2, n2));
    const Number factor =
        size > 0.0 ? (c.c_i * c.c_m) * at.flow.rate / (size > 0.0 ? size : Math::number(1)) : Math::number(0);
    return {c.c_i * at.flow.rate, -factor * n2};
  }
};

}  // namespace fiberfate
