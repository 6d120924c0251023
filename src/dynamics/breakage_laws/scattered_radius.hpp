// Radii of breakage that scatter between two bounds.
#pragma once

#include <algorithm>
#include <cmath>

#include "dynamics/breakage_laws/breakage_parameters.hpp"

namespace fiberfate {

/// Probability that a hinge of radius R breaks, (3.32), (3.33):
///   x = (R_max − R)/(R_max − R_min) clamped to [0, 1],   P = (e^{m x} − 1)/(e^m − 1)
/// Source: thesis section 3.3.3.
[[nodiscard]] inline double break_probability(const BreakageParameters& breakage, double radius) {
  const double x = std::clamp(
      (breakage.maximum_radius - radius) / (breakage.maximum_radius - breakage.minimum_radius), 0.0, 1.0);
  return std::expm1(breakage.exponent * x) / std::expm1(breakage.exponent);
}

/// Radius at which a hinge breaks whose strength is drawn, m: the quantile of P for a number u in (0, 1), so
/// that the share of hinges with a critical radius above R is P(R).
[[nodiscard]] inline double critical_radius(const BreakageParameters& breakage, double u) {
  const double x = std::log1p(u * std::expm1(breakage.exponent)) / breakage.exponent;
  return breakage.maximum_radius - x * (breakage.maximum_radius - breakage.minimum_radius);
}

}  // namespace fiberfate
