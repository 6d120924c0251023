// No retardation.
#pragma once

#include "base/law_text.hpp"
#include "continuum/orientation_constants.hpp"

namespace fiberfate {

/// The rate as it is.
template <class Math>
struct NoRetardation {
  static constexpr LawText text = {"none", "No retardation.", ""};

  /// Factor by which small changes of the principal values are slower near a steady state.
  static double slowness(const OrientationConstants&) { return 1; }

  [[gnu::always_inline]] static typename Math::Symmetric retarded(const OrientationConstants&,
                                                                  const typename Math::Symmetric& rate) {
    return rate;
  }
};

}  // namespace fiberfate
