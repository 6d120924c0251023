// Anisotropic rotary diffusion.
#pragma once

#include "base/law_text.hpp"
#include "continuum/orientation_constants.hpp"

namespace fiberfate {

/// C = b1 I + b2 A + b3 A² + b4 D/rate + b5 D²/rate².
template <class Math>
struct ArdDiffusion {
  static constexpr LawText text = {"ard",
                                   "C = b1 I + b2 A + b3 A² + b4 D/rate + b5 D²/rate².",
                                   "Phelps, Tucker, J. Non-Newton. Fluid Mech. 156, 165 (2009)",
                                   {"b1", "b2", "b3", "b4", "b5"}};
  static constexpr bool depends_on_orientation = true;

  [[gnu::always_inline]] static typename Math::Diffusion diffusion(const OrientationConstants& c,
                                                                   const typename Math::Place& at) {
    const typename Math::Symmetric &a = at.second, &n = at.unit_strain;
    return {c.b1 * at.flow.rate, at.flow.rate * (c.b2 * a + c.b3 * square(a) + c.b4 * n + c.b5 * square(n))};
  }
};

}  // namespace fiberfate
