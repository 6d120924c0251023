// Finds confidence intervals from the profile of the likelihood, which follows the curvature that
// linearisation neglects.
#pragma once

#include <vector>

#include "calibration/fit.hpp"

namespace fiberfate {

/// Holds the profile of one parameter: the least chi^2 with the parameter held, over its value.
struct Profile {
  ConfidenceInterval
      interval;      ///< infinite or at the parameter's bound where the profile stays below the limit
  double limit = 0;  ///< chi^2 at the ends of the interval
  std::vector<double> values;  ///< where the profile was computed, rising, SI
  std::vector<double> chi_squares;
};

/// Profiles one free parameter of a fit: the interval is where the profile stays below chi^2_min + s^2 t^2,
/// with t as in the linearised interval, which it equals for a model linear in its parameters. The ends are
/// accurate to 1e-4 of the interval. Without degrees of freedom (and unknown noise) the interval is NaN.
/// Source: Bates, Watts, Nonlinear Regression Analysis and Its Applications (1988), section 6.1.
[[nodiscard]] Profile profile(const FitProblem& problem, const FitResult& fit, std::size_t parameter,
                              const FitOptions& options = {});

}  // namespace fiberfate
