// The retarding principal rate.
#pragma once

#include "base/law_text.hpp"
#include "continuum/orientation_constants.hpp"

namespace fiberfate {

/// r_i -> r_i - alpha (r_i - beta (r_i² + 2 r_j r_k)), r_i the rates of the principal values.
template <class Math>
struct RprRetardation {
  static constexpr LawText text = {
      "rpr",
      "Retarding principal rate; with beta = 0 the same as rsc with kappa = 1 - alpha.",
      "Tseng, Chang, Hsu, Phys. Fluids 25, 53103 (2013)",
      {"alpha", "beta"}};

  static double slowness(const OrientationConstants& c) { return 1 - c.alpha; }

  /// What is taken from the rate r_i of a principal value; the others are r_j and r_k.
  template <class Number>
  [[gnu::always_inline]] static Number taken(const OrientationConstants& c, const Number& r_i,
                                             const Number& r_j, const Number& r_k) {
    return c.alpha * (r_i - c.beta * (r_i * r_i + 2.0 * r_j * r_k));
  }
  /// What is left of it, but for the mean of the three, which products of rates leave and the trace must not.
  static double left(const OrientationConstants& c, double r_i, double r_j, double r_k) {
    return r_i - taken(c, r_i, r_j, r_k);
  }
  static constexpr bool shifts_the_trace = true;
};

}  // namespace fiberfate
