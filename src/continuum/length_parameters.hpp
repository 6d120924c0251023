// Parameters that several length laws share.
#pragma once

#include "continuum/law_parameter.hpp"

namespace fiberfate {

/// Zero would divide by nothing: a pascal and a nanometre are less than any fiber has.
inline LawParameter fiber_strength() {
  return {"sigma_u", "Pa", "Tensile strength of the fiber", 2e9, 1};
}
inline LawParameter fiber_diameter() {
  return {"d_f", "m", "Diameter of the fiber", 19e-6, 1e-9};
}
inline LawParameter interaction_coefficient_parameter() {
  return {"lambda", "1", "Interaction coefficient of the unbreakable length", required_value};
}

}  // namespace fiberfate
