// The exact closure of Jeffery's equation.
#pragma once

#include "base/law_text.hpp"

namespace fiberfate {

/// A4 of an isotropic state carried by the flow (exact_closure.hpp), each of eight states by itself.
template <class Math>
struct ExactClosure {
  static constexpr LawText text = {"exact", "Exact for Jeffery's equation from an isotropic state; slow.",
                                   "Montgomery-Smith et al., J. Fluid Mech. 680, 321 (2011)"};

  [[gnu::always_inline]] static typename Math::Orthotropic components(const typename Math::Frame& frame) {
    return Math::exact(frame);
  }
};

}  // namespace fiberfate
