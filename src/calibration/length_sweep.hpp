// Compares the lengths of a sweep with measurements and finds the best value of the swept parameter.
#pragma once

#include <vector>

namespace fiberfate {

/// What was measured of one mean length at one place, with what every value of the sweep predicts.
struct SweptLength {
  std::vector<double> measured;   ///< of every sample, m
  std::vector<double> predicted;  ///< one a value, m
};

/// The errors of a sweep and its optima.
struct SweepOutcome {
  std::vector<double> errors;      ///< average error (4.8) of each value, %
  double best_value = 0;           ///< of the least average error, refined between the values
  double best_error = 0;           ///< %
  double least_squares_value = 0;  ///< of the least sum of squared relative errors
  double least_squares_error = 0;  ///< relative standard deviation of the measurements about it, 1
  double standard_error = 0;       ///< of the logarithm of least_squares_value, 1
};

/// Evaluates a sweep over rising values (at least three). Between them the logarithm of every length is a
/// cubic spline in the logarithm of the value (in the value itself where one is not positive): lengths are
/// smooth in it. Errors (4.7) are of the mean over the samples of a place, relative to it. The optimum of
/// (4.8) has kinks, one a place; that of least squares over all samples is smooth and less noisy. The
/// standard error is that of linearised least squares with the scatter that is found. Raises InputError for
/// fewer than three values or some that do not rise, for no lengths, and for such that are not positive.
/// Source: thesis (4.7), (4.8).
[[nodiscard]] SweepOutcome evaluate_sweep(const std::vector<double>& values,
                                          const std::vector<SweptLength>& lengths);

}  // namespace fiberfate
