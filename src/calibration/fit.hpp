// Fits parameters by weighted least squares, and says how well the data determine them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibration/fit_problem.hpp"

namespace fiberfate {

/// What to search for and how hard.
struct FitOptions {
  double level = 0.95;  ///< of confidence intervals
  int most_iterations = 200;
  int starts = 1;  ///< searches from as many places; the best is kept (1: from the initial values only)
  std::uint64_t seed = 1;  ///< of the other places

  /// Raises InputError unless 0 < level < 1 and there is at least one iteration and one start.
  void check() const;
};

/// An interval; an end that the data do not determine is infinite, one that cannot be told is NaN.
struct ConfidenceInterval {
  double lower = 0;
  double upper = 0;
};

/// How a parameter came out.
enum class ParameterOutcome {
  determined,
  fixed,
  at_bound,       ///< the search ended at a bound: its interval says nothing
  unidentifiable  ///< the data do not determine it
};

/// The estimate of one parameter, SI.
struct ParameterEstimate {
  std::string name;
  std::string unit;
  double value = 0;
  double standard_error =
      0;  ///< NaN when it cannot be told, infinite when the data do not determine the parameter
  ConfidenceInterval
      interval;  ///< by linearisation, at FitOptions::level; symmetric in the logarithm of logarithmic ones
  ParameterOutcome outcome = ParameterOutcome::determined;
};

/// What kinds of things a user must know about a fit.
enum class FindingKind {
  exactly_determined,  ///< no degrees of freedom: the law passes through the data, which cannot test it
  unidentifiable,      ///< a combination of parameters that changes no prediction
  nearly_collinear,    ///< two parameters whose correlation exceeds 0.99
  at_bound,
  not_converged,
  several_minima,  ///< a profile that jumps from one minimum to another, or an interval in parts
  better_fit       ///< a profile that came below the fit
};

/// One thing that a user must know about a fit, in a sentence.
struct Finding {
  FindingKind kind;
  std::string text;
};

/// A fit. Matrices are of the free parameters, in their order.
struct FitResult {
  std::vector<ParameterEstimate> parameters;  ///< all, fixed ones included
  std::vector<double> values;                 ///< of all parameters
  std::vector<double> predictions;            ///< of all series, one after another
  double chi_square = 0;                      ///< sum of squared residuals over uncertainties
  std::ptrdiff_t degrees_of_freedom = 0;      ///< observations less parameters determined by them
  double noise_scale = 0;                     ///< s: 1 with known noise, else sqrt(chi^2/df), NaN without df
  Eigen::MatrixXd covariance;                 ///< by linearisation; of determined combinations only
  Eigen::MatrixXd correlation;
  Eigen::MatrixXd position_covariance;  ///< the same in the coordinates of the search (FitCoordinates)
  std::vector<Finding> findings;
  bool converged = false;
  int iterations = 0;
  int starts = 1;
  int agreeing_starts = 1;  ///< how many of the starts reached this minimum
};

/// Fits a problem. Raises InputError for a problem that cannot be posed (FitProblem::check), impossible
/// options, or a model that fails at the initial values.
///
/// The estimate minimises chi^2 = sum (observed - predicted)^2/uncertainty^2. Its covariance is s^2 (J^T
/// J)^-1 with the Jacobian J of the weighted residuals; the pseudo-inverse leaves out combinations whose
/// singular value, in comparable coordinates, is below 1e-7 of the largest, and names them. Intervals are
/// value +- t s.e. with Student's t. Neglects the curvature of the model: see profile_interval and bootstrap.
/// Source: Seber, Wild, Nonlinear Regression (1989).
[[nodiscard]] FitResult fit(const FitProblem& problem, const FitOptions& options = {});

}  // namespace fiberfate
