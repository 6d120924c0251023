// The Newtonian viscosity.
#pragma once

#include <span>
#include <vector>

#include "base/law_text.hpp"
#include "continuum/law_parameter.hpp"
#include "continuum/melt_state.hpp"
#include "continuum/viscosity_parameters.hpp"

namespace fiberfate {

/// eta = eta_0.
struct Newtonian {
  double viscosity;  ///< eta_0, Pa s

  static constexpr LawText text = {"newtonian", "eta = eta_0", ""};
  static std::vector<LawParameter> parameters() { return {viscosity_at_rest()}; }
  static Newtonian of(std::span<const double> v) { return {v[0]}; }

  double operator()(const MeltState&) const { return viscosity; }
};

}  // namespace fiberfate
