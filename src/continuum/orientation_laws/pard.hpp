// Rotary diffusion along the principal axes of the orientation, with one constant.
#pragma once

#include "base/law_text.hpp"
#include "continuum/orientation_constants.hpp"

namespace fiberfate {

/// C = C_I R diag(1, Omega, 1 - Omega) Rᵀ, R the axes of A.
template <class Math>
struct PardDiffusion {
  static constexpr LawText text = {"pard",
                                   "C = C_I R diag(1, Omega, 1 - Omega) Rᵀ in the axes of A.",
                                   "Tseng, Chang, Hsu, J. Rheol. 62, 313 (2018)",
                                   {"C_I", "Omega"}};
  static constexpr bool depends_on_orientation = true;
  static constexpr bool reads_axes = true;

  [[gnu::always_inline]] static typename Math::Diffusion diffusion(const OrientationConstants& c,
                                                                   const typename Math::Place& at) {
    return {Math::number(0), c.c_i * Math::along_axes(at, 1, c.omega, 1 - c.omega)};
  }
};

}  // namespace fiberfate
