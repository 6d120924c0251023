// The breakage rate of Durin.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/law_text.hpp"

namespace fiberfate {

/// P = C_B rate min(1, (1 - exp(-B))/(1 - exp(-1))): some break below L_ub, all that can above it.
struct DurinBreakage {
  static constexpr LawText text = {"durin",
                                   "As phelps, with P = C_B rate min(1, (1 - exp(-(L/L_ub)^4))/(1 - 1/e))",
                                   "Durin et al., Composites A 48, 47 (2013)"};

  static double share(double buckling_number) {
    return std::min(1.0, std::expm1(-buckling_number) / std::expm1(-1.0));
  }
};

}  // namespace fiberfate
