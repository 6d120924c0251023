// Cross' viscosity with the Williams-Landel-Ferry shift.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "base/law_text.hpp"
#include "continuum/law_parameter.hpp"
#include "continuum/melt_state.hpp"
#include "continuum/viscosity_cross.hpp"
#include "continuum/viscosity_parameters.hpp"

namespace fiberfate {

/// Cross with the Williams-Landel-Ferry shift of temperature and pressure:
///   eta_0 = D_1 exp(-A_1 (T - T_s)/(A_2 + T - T_s)),   T_s = D_2 + D_3 p,   A_2 = A_2* + D_3 p.
/// Below T_s the melt is solid and the law does not hold; the viscosity stays D_1 there, at most.
struct CrossWlf {
  double critical_stress;  ///< tau, Pa
  double index;            ///< n, 1
  double d_1;              ///< Pa s
  double d_2;              ///< K
  double d_3 = 0;          ///< K/Pa
  double a_1 = 0;          ///< 1
  double a_2 = 51.6;       ///< A_2*, K

  static constexpr LawText text = {
      "cross_wlf", "Cross, with eta_0 = D1 exp(-A1 (T - Ts)/(A2 + T - Ts)), Ts = D2 + D3 p, A2 = A2s + D3 p",
      "Cross, J. Colloid Sci. 20, 417 (1965); Williams, Landel, Ferry, J. Am. Chem. Soc. 77, 3701 (1955)"};
  /// At 0 K, which stands for a temperature that nobody gave, the melt would be taken for solid.
  static constexpr bool needs_temperature = true;
  static std::vector<LawParameter> parameters() {
    return {stress_half_way(),
            power_law_index(1),
            {"D1", "Pa s", "Viscosity at the reference temperature", required_value, least_viscosity},
            {"D2", "K", "Reference temperature without pressure", required_value},
            {"D3", "K/Pa", "Rise of the reference temperature with pressure", 0.0},
            {"A1", "1", "First constant of the WLF shift", required_value},
            {"A2s", "K", "Second constant of the WLF shift", 51.6, least_viscosity}};
  }
  static CrossWlf of(std::span<const double> v) { return {v[0], v[1], v[2], v[3], v[4], v[5], v[6]}; }

  double operator()(const MeltState& melt) const {
    const double above = std::max(0.0, melt.temperature - (d_2 + d_3 * melt.pressure));
    const double shift = -a_1 * above / (a_2 + d_3 * melt.pressure + above);
    return Cross{d_1 * std::exp(shift), critical_stress, index}(melt);
  }
};

}  // namespace fiberfate
