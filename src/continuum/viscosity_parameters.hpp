// Parameters that several viscosity laws share.
#pragma once

#include "continuum/law_parameter.hpp"

namespace fiberfate {

/// Zero would make the melt weigh nothing.
inline constexpr double least_viscosity = 1e-9;

inline LawParameter viscosity_at_rest() {
  return {"eta_0", "Pa s", "Viscosity at rest", required_value, least_viscosity};
}
/// Above 1 the viscosity of Cross' law would vanish at rest.
inline LawParameter power_law_index(double highest) {
  return {"n", "1", "Power-law index", required_value, 0, highest};
}
inline LawParameter stress_half_way() {
  return {"tau", "Pa", "Stress at which shear thinning is half way", required_value, least_viscosity};
}

}  // namespace fiberfate
