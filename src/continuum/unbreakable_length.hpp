// States the unbreakable-length model of fiber attrition (Bechara), with constant or power-law rate
// constants.
#pragma once

#include <cmath>

#include "continuum/length_relaxation.hpp"

namespace fiberfate {

/// Approaches a given length at a given rate, whatever the flow: L_inf and k_f constant
/// (thesis 5.7, 5.10, 5.11). It describes one experiment; the laws below predict its two constants.
struct ConstantRelaxation {
  double rate_constant;       ///< k_f, 1/s
  double equilibrium_length;  ///< L_inf, m

  LengthRelaxation operator()(const LengthFlow&) const { return {rate_constant, equilibrium_length}; }
};

/// Predicts attrition from the unbreakable length:
///   L_inf = lambda d_f sqrt(sigma_u/(eta rate)),   k_f = xi rate.
/// sigma_u and eta rate must be in one unit. Neglects that fragments and orientation interact.
/// Source: Bechara, Goris, Yanev, Brands, Osswald, "Novel modeling approach for fiber breakage during molding
/// of long fiber-reinforced thermoplastics", Phys. Fluids 33 (2021); thesis (2.9), (2.10), (4.3), (4.4) with
/// d_f outside the root, which is the form that the thesis computes with.
struct UnbreakableLength {
  double lambda;           ///< interaction coefficient, 1
  double breakage_factor;  ///< xi, 1
  double strength;         ///< sigma_u, Pa
  double diameter;         ///< d_f, m

  LengthRelaxation operator()(const LengthFlow& flow) const {
    const double stress = flow.viscosity * flow.rate;
    if (!(stress > 0)) return {breakage_factor * flow.rate, HUGE_VAL};
    return {breakage_factor * flow.rate, lambda * diameter * std::sqrt(strength / stress)};
  }
};

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

  LengthRelaxation operator()(const LengthFlow& flow) const {
    const double stress = flow.viscosity * flow.rate;
    if (!(stress > 0)) return {0, HUGE_VAL};
    return {breakage_factor * std::pow(flow.rate, beta),
            lambda * diameter * std::pow(strength / stress, alpha)};
  }
};

}  // namespace fiberfate
