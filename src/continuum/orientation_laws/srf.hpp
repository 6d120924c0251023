// The strain reduction factor.
#pragma once

#include "base/law_text.hpp"
#include "continuum/orientation_constants.hpp"

namespace fiberfate {

/// The whole rate times srf; not objective.
template <class Math>
struct SrfRetardation {
  static constexpr LawText text = {"srf",
                                   "Strain reduction factor on the whole rate; not objective.",
                                   "Huynh, MS thesis, University of Illinois (2001)",
                                   {"srf"}};

  static double slowness(const OrientationConstants& c) { return c.srf; }

  [[gnu::always_inline]] static typename Math::Symmetric retarded(const OrientationConstants& c,
                                                                  const typename Math::Symmetric& rate) {
    return c.srf * rate;
  }
};

}  // namespace fiberfate
