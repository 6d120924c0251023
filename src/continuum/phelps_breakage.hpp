// The breakage rate of Phelps and Tucker.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/law_text.hpp"

namespace fiberfate {

/// P = C_B rate max(0, 1 - exp(1 - B)): nothing breaks below L_ub.
struct PhelpsBreakage {
  static constexpr LawText text = {
      "phelps", "dN_i/dt = -P_i N_i + sum R_ik N_k, P = C_B rate max(0, 1 - exp(1 - (L/L_ub)^4))",
      "Phelps, Abd El-Rahman, Kunc, Tucker, Composites A 51, 11 (2013)"};

  static double share(double buckling_number) { return std::max(0.0, -std::expm1(1 - buckling_number)); }
};

}  // namespace fiberfate
