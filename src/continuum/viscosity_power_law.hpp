// The power law of viscosity.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "base/law_text.hpp"
#include "continuum/law_parameter.hpp"
#include "continuum/melt_state.hpp"
#include "continuum/viscosity_parameters.hpp"

namespace fiberfate {

/// eta = K rate^(n-1) (Ostwald-de Waele); below `lowest_rate` the viscosity stays what it is there, since for
/// n < 1 the law is infinite at rest.
struct PowerLaw {
  double consistency;         ///< K, Pa s^n
  double index;               ///< n, 1
  double lowest_rate = 1e-3;  ///< 1/s

  static constexpr LawText text = {"power_law", "eta = K rate^(n-1), constant below the lowest rate", ""};
  static std::vector<LawParameter> parameters() {
    return {{"K", "1", "Consistency, in Pa s^n", required_value, least_viscosity},
            power_law_index(2),
            {"lowest_rate", "1/s", "Rate below which the viscosity no longer rises", 1e-3}};
  }
  static PowerLaw of(std::span<const double> v) { return {v[0], v[1], v[2]}; }

  double operator()(const MeltState& melt) const {
    return consistency * std::pow(std::max(melt.rate, lowest_rate), index - 1);
  }
};

}  // namespace fiberfate
