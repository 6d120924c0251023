// The elastic hinge of beam theory.
#pragma once

#include "base/law_text.hpp"

namespace fiberfate {

/// Elastic hinge of Euler-Bernoulli beam theory: moment M = E I theta / l̄ with turning angle theta between
/// the rods and l̄ the mean of their lengths, about p_before × p_after. Source: thesis (3.10) to (3.12), where
/// alpha is the angle.
template <class Math>
struct ElasticHinge {
  using Number = typename Math::Number;

  static constexpr LawText text = {"elastic", "an Euler-Bernoulli beam", "thesis equations 3.10 to 3.12"};

  [[nodiscard]] static ElasticHinge make() { return {}; }

  /// Returns M / ((E I / l̄) sin theta) for sin²(theta/2) in [0, 1): here theta / sin theta.
  [[gnu::always_inline]] Number operator()(const Number& squared_half_sine) const {
    return Math::arcsine_ratio(squared_half_sine) / Math::square_root(1.0 - squared_half_sine);
  }
};

}  // namespace fiberfate
