// The length law of a given final length and rate constant.
#pragma once

#include <span>
#include <vector>

#include "base/law_text.hpp"
#include "continuum/law_parameter.hpp"
#include "continuum/length_relaxation.hpp"

namespace fiberfate {

/// Approaches a given length at a given rate, whatever the flow: L_inf and k_f constant
/// (thesis 5.7, 5.10, 5.11). It describes one experiment; the other laws predict its two constants.
struct ConstantRelaxation {
  double rate_constant;       ///< k_f, 1/s
  double equilibrium_length;  ///< L_inf, m

  static constexpr LawText text = {
      "constant", "A given final length and rate constant: DL/Dt = -k_f (L - L_inf)", "thesis equation 5.7"};
  static std::vector<LawParameter> parameters() {
    return {{"k_f", "1/s", "Rate constant of the decay", required_value},
            {"L_inf", "m", "Final length", required_value}};
  }
  static ConstantRelaxation of(std::span<const double> v) { return {v[0], v[1]}; }

  LengthRelaxation operator()(const LengthFlow&) const { return {rate_constant, equilibrium_length}; }
};

}  // namespace fiberfate
