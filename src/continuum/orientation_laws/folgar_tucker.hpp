// Isotropic rotary diffusion.
#pragma once

#include "base/law_text.hpp"
#include "continuum/orientation_constants.hpp"

namespace fiberfate {

/// C = C_I I.
template <class Math>
struct FolgarTuckerDiffusion {
  static constexpr LawText text = {
      "folgar_tucker", "C = C_I I.", "Folgar, Tucker, J. Reinf. Plast. Compos. 3, 98 (1984)", {"C_I"}};
  static constexpr bool depends_on_orientation = false;

  [[gnu::always_inline]] static typename Math::Diffusion diffusion(const OrientationConstants& c,
                                                                   const typename Math::Place& at) {
    return {c.c_i * at.flow.rate, at.nothing};
  }
};

}  // namespace fiberfate
