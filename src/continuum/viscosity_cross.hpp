// Cross' viscosity.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "base/law_text.hpp"
#include "continuum/law_parameter.hpp"
#include "continuum/melt_state.hpp"
#include "continuum/viscosity_parameters.hpp"

namespace fiberfate {

/// eta = eta_0/(1 + (eta_0 rate/tau)^(1-n)) (Cross 1965).
struct Cross {
  double zero_rate_viscosity;  ///< eta_0, Pa s
  double critical_stress;      ///< tau, Pa: where shear thinning is half way
  double index;                ///< n, 1

  static constexpr LawText text = {"cross", "eta = eta_0/(1 + (eta_0 rate/tau)^(1-n))",
                                   "Cross, J. Colloid Sci. 20, 417 (1965)"};
  static std::vector<LawParameter> parameters() {
    return {viscosity_at_rest(), stress_half_way(), power_law_index(1)};
  }
  static Cross of(std::span<const double> v) { return {v[0], v[1], v[2]}; }

  double operator()(const MeltState& melt) const {
    return zero_rate_viscosity / (1 + std::pow(zero_rate_viscosity * melt.rate / critical_stress, 1 - index));
  }
};

}  // namespace fiberfate
