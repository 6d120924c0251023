// States the stress-induced model of fiber attrition (thesis, chapter 5), and solves it for its constants.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/law_text.hpp"
#include "continuum/length_parameters.hpp"
#include "continuum/length_relaxation.hpp"

namespace fiberfate {

/// Predicts attrition from the shear stress alone:
///   L_inf/d_f = lambda (eta rate/sigma_u)^(-alpha),   k_f = k_0 (eta rate/sigma_u)^beta   (thesis 5.8, 5.9).
/// Only the ratio of stress and strength enters, so both must be in one unit: a strength ten times too large
/// changes lambda by 10^(-alpha) and k_0 by 10^beta and hides it in the fit. Neglects rate effects beyond the
/// stress.
struct StressInduced {
  double lambda;    ///< 1
  double alpha;     ///< 1
  double k_0;       ///< 1/s
  double beta;      ///< 1
  double strength;  ///< sigma_u, Pa
  double diameter;  ///< d_f, m

  static constexpr LawText text = {
      "stress_induced", "L_inf = lambda d_f (eta rate/sigma_u)^-alpha, k_f = k_0 (eta rate/sigma_u)^beta",
      "thesis equations 5.8, 5.9"};
  static std::vector<LawParameter> parameters() {
    return {interaction_coefficient_parameter(),
            {"alpha", "1", "Exponent of the final length", required_value},
            {"k_0", "1/s", "Rate constant at a stress equal to the strength", required_value},
            {"beta", "1", "Exponent of the rate constant", required_value},
            fiber_strength(),
            fiber_diameter()};
  }
  static StressInduced of(std::span<const double> v) { return {v[0], v[1], v[2], v[3], v[4], v[5]}; }

  LengthRelaxation operator()(const LengthFlow& flow) const;
};

/// What a rheometer run at one speed determines: the decay of the length towards its final value.
struct SteadyAttrition {
  double rate;                  ///< 1/s
  double viscosity;             ///< Pa s
  LengthRelaxation relaxation;  ///< measured k_f and L_inf
};

/// lambda = (L_inf/d_f) (eta rate/sigma_u)^alpha for one run (thesis 5.1, 5.2 with alpha = 1/2; the
/// logarithm printed there was not applied in the thesis' own numbers).
[[nodiscard]] double interaction_coefficient(const SteadyAttrition& run, double alpha, double strength,
                                             double diameter);

/// Solves the stress-induced law for its four constants from runs at two different stresses
/// (thesis 5.12, 5.13, 5.16, 5.17). Four numbers fix four constants: the law passes through both runs
/// exactly, and they cannot test it. Raises InputError when the stresses are equal or a number is not
/// positive.
[[nodiscard]] StressInduced solve_stress_induced(const std::array<SteadyAttrition, 2>& runs, double strength,
                                                 double diameter);

/// The exponent of k_f = xi rate^beta through two runs at different rates (thesis 5.15); raises as
/// above.
[[nodiscard]] double rate_exponent(const std::array<SteadyAttrition, 2>& runs);

}  // namespace fiberfate
