// The unbreakable-length model of fiber attrition (Bechara).
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "base/law_text.hpp"
#include "continuum/length_parameters.hpp"
#include "continuum/length_relaxation.hpp"

namespace fiberfate {

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

  static constexpr LawText text = {"unbreakable_length",
                                   "L_inf = lambda d_f sqrt(sigma_u/(eta rate)), k_f = xi rate",
                                   "thesis equations 4.3, 4.4"};
  static std::vector<LawParameter> parameters() {
    return {interaction_coefficient_parameter(),
            {"xi", "1", "Breakage per unit of strain", required_value},
            fiber_strength(),
            fiber_diameter()};
  }
  static UnbreakableLength of(std::span<const double> v) { return {v[0], v[1], v[2], v[3]}; }

  LengthRelaxation operator()(const LengthFlow& flow) const {
    const double stress = flow.viscosity * flow.rate;
    if (!(stress > 0)) return {breakage_factor * flow.rate, HUGE_VAL};
    return {breakage_factor * flow.rate, lambda * diameter * std::sqrt(strength / stress)};
  }
};

}  // namespace fiberfate
