// Carreau's and Yasuda's viscosity.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "base/law_text.hpp"
#include "continuum/law_parameter.hpp"
#include "continuum/melt_state.hpp"
#include "continuum/viscosity_parameters.hpp"

namespace fiberfate {

/// eta = eta_inf + (eta_0 - eta_inf) [1 + (time rate)^a]^((n-1)/a); a = 2 is Carreau (1972), other a Yasuda
/// (1979).
struct Carreau {
  double zero_rate_viscosity;          ///< eta_0, Pa s
  double time;                         ///< s
  double index;                        ///< n, 1
  double infinite_rate_viscosity = 0;  ///< eta_inf, Pa s
  double transition = 2;               ///< a, 1

  static constexpr LawText text = {
      "carreau", "eta = eta_inf + (eta_0 - eta_inf) [1 + (time rate)^a]^((n-1)/a)",
      "Carreau, Trans. Soc. Rheol. 16, 99 (1972); Yasuda, PhD thesis, MIT (1979)"};
  static std::vector<LawParameter> parameters() {
    return {viscosity_at_rest(),
            {"time", "s", "Time constant", required_value},
            power_law_index(2),
            {"eta_inf", "Pa s", "Viscosity at infinite rate", 0.0},
            {"a", "1", "Width of the transition; 2 is Carreau's", 2.0, 1e-3}};
  }
  static Carreau of(std::span<const double> v) { return {v[0], v[1], v[2], v[3], v[4]}; }

  double operator()(const MeltState& melt) const {
    const double thinning = std::pow(1 + std::pow(time * melt.rate, transition), (index - 1) / transition);
    return infinite_rate_viscosity + (zero_rate_viscosity - infinite_rate_viscosity) * thinning;
  }
};

}  // namespace fiberfate
