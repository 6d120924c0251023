// Rotary diffusion along the principal axes of the orientation, with three constants.
#pragma once

#include "base/law_text.hpp"
#include "continuum/orientation_constants.hpp"

namespace fiberfate {

/// C = C_I R diag(D1, D2, D3) Rᵀ, R the axes of A.
template <class Math>
struct MrdDiffusion {
  static constexpr LawText text = {"mrd",
                                   "C = C_I R diag(D1, D2, D3) Rᵀ in the axes of A.",
                                   "Bakharev, Yu, Speight, Wang, ANTEC (2018)",
                                   {"C_I", "D1", "D2", "D3"}};
  static constexpr bool depends_on_orientation = true;
  static constexpr bool reads_axes = true;

  [[gnu::always_inline]] static typename Math::Diffusion diffusion(const OrientationConstants& c,
                                                                   const typename Math::Place& at) {
    return {Math::number(0), c.c_i * Math::along_axes(at, c.d1, c.d2, c.d3)};
  }
};

}  // namespace fiberfate
