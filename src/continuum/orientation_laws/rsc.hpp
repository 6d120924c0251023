// The reduced strain closure.
#pragma once

#include "base/law_text.hpp"
#include "continuum/orientation_constants.hpp"

namespace fiberfate {

/// The rates of the principal values times kappa.
template <class Math>
struct RscRetardation {
  static constexpr LawText text = {"rsc",
                                   "Reduced strain closure: the principal values change kappa times as fast.",
                                   "Wang, O'Gara, Tucker, J. Rheol. 52, 1179 (2008)",
                                   {"kappa"}};

  static double slowness(const OrientationConstants& c) { return c.kappa; }

  /// What is taken from the rate r_i of a principal value; the others are r_j and r_k.
  template <class Number>
  [[gnu::always_inline]] static Number taken(const OrientationConstants& c, const Number& r_i, const Number&,
                                             const Number&) {
    return (1 - c.kappa) * r_i;
  }
  /// What is left of it.
  static double left(const OrientationConstants& c, double r_i, double, double) { return c.kappa * r_i; }
};

}  // namespace fiberfate
