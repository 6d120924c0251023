// Finds confidence intervals from the profile of the likelihood, which follows the curvature that
// linearisation neglects.
#pragma once

#include <vector>

#include "calibration/fit.hpp"

namespace fiberfate {

/// The profile of one parameter: the least chi^2 with the parameter held, over its value.
struct Profile {
  ConfidenceInterval
      interval;      ///< infinite or at the parameter's bound where the profile stays below the limit
  double limit = 0;  ///< chi^2 at the ends of the interval
  std::vector<double> values;  ///< where the profile was computed, rising, SI
  std::vector<double> chi_squares;
  /// What a user must know before quoting the interval: a better fit than the one given, a jump between two
  /// minima, an interval in parts.
  std::vector<Finding> findings;
};

/// Profiles one free parameter of a fit: the interval is where the profile stays below chi^2_min + s^2 t^2,
/// with t as in the linearised interval, which it equals for a model linear in its parameters. The ends are
/// accurate to 1e-4 of the interval. Without degrees of freedom (and unknown noise) the interval is NaN.
///
/// The profile is that of the lowest minimum found at every value (ProfileWalk), not of the one next to the
/// fit. Where it comes below the fit itself, the interval belongs to that better minimum. Where the other
/// parameters jump from one minimum to another, or values beyond an end are as likely, the findings say so;
/// the interval then reaches from the outermost end to the outermost end. Raises InputError for a parameter
/// that is not free. Source: Bates, Watts, Nonlinear Regression Analysis and Its Applications (1988),
/// section 6.1.
[[nodiscard]] Profile profile(const FitProblem& problem, const FitResult& fit, std::size_t parameter,
                              const FitOptions& options = {});

}  // namespace fiberfate
