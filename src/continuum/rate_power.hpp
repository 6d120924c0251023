// The length law of a power of the stress and a power of the rate.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "base/law_text.hpp"
#include "continuum/length_parameters.hpp"
#include "continuum/length_relaxation.hpp"

namespace fiberfate {

/// Predicts attrition with a power of the stress for L_inf and a power of the rate for k_f:
///   L_inf = lambda d_f (eta rate/sigma_u)^(-alpha),   k_f = xi rate^beta   (thesis 5.8, 5.14).
/// alpha = 1/2 and beta = 1 make it UnbreakableLength. xi carries the unit s^(beta-1).
struct RatePower {
  double lambda;           ///< 1
  double alpha;            ///< 1
  double breakage_factor;  ///< xi, s^(beta-1)
  double beta;             ///< 1
  double strength;         ///< sigma_u, Pa
  double diameter;         ///< d_f, m

  static constexpr LawText text = {"rate_power",
                                   "L_inf = lambda d_f (eta rate/sigma_u)^-alpha, k_f = xi rate^beta",
                                   "thesis equations 5.8, 5.14"};
  static std::vector<LawParameter> parameters() {
    return {interaction_coefficient_parameter(),
            {"alpha", "1", "Exponent of the final length", 0.5},
            {"xi", "1", "Breakage factor, in s^(beta-1)", required_value},
            {"beta", "1", "Exponent of the rate constant", required_value},
            fiber_strength(),
            fiber_diameter()};
  }
  static RatePower of(std::span<const double> v) { return {v[0], v[1], v[2], v[3], v[4], v[5]}; }

  LengthRelaxation operator()(const LengthFlow& flow) const {
    const double stress = flow.viscosity * flow.rate;
    if (!(stress > 0)) return {0, HUGE_VAL};
    return {breakage_factor * std::pow(flow.rate, beta),
            lambda * diameter * std::pow(strength / stress, alpha)};
  }
};

}  // namespace fiberfate
