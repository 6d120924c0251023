// No rotary diffusion.
#pragma once

#include "base/law_text.hpp"
#include "continuum/orientation_constants.hpp"

namespace fiberfate {

/// C = 0.
template <class Math>
struct NoDiffusion {
  static constexpr LawText text = {"jeffery", "No diffusion.", "Jeffery, Proc. R. Soc. A 102, 161 (1922)"};
  static constexpr bool depends_on_orientation = false;

  [[gnu::always_inline]] static typename Math::Diffusion diffusion(const OrientationConstants&,
                                                                   const typename Math::Place& at) {
    return {Math::number(0), at.nothing};
  }
};

}  // namespace fiberfate
