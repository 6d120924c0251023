// What a user may choose about breakage.
#pragma once

#include <string>

namespace fiberfate {

/// The law of breakage and its constants (thesis section 3.3.3).
struct BreakageParameters {
  std::string law = "none";           ///< a row of breakage_laws()
  double critical_radius = 204.6e-6;  ///< R_crit of `fixed`, m; the default is the loop test's mean
  double minimum_radius = 119e-6;     ///< R_min of `probability` and `strength`, m
  double maximum_radius = 371e-6;     ///< R_max of `probability` and `strength`, m
  double exponent = 15;               ///< m of equation (3.33)
  double check_interval = 1e-3;       ///< physical time between two checks, s
};

}  // namespace fiberfate
