// Rotary diffusion of the square of the orientation.
#pragma once

#include "base/law_text.hpp"
#include "continuum/orientation_constants.hpp"

namespace fiberfate {

/// C = b1 I + b3 A².
template <class Math>
struct WptDiffusion {
  static constexpr LawText text = {
      "wpt", "C = b1 I + b3 A².", "Favaloro, Tucker, Composites A 126, 105605 (2019)", {"b1", "b3"}};
  static constexpr bool depends_on_orientation = true;

  [[gnu::always_inline]] static typename Math::Diffusion diffusion(const OrientationConstants& c,
                                                                   const typename Math::Place& at) {
    return {c.b1 * at.flow.rate, (c.b3 * at.flow.rate) * square(at.second)};
  }
};

}  // namespace fiberfate
