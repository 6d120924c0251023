// Scans the error of a model over one parameter, as the thesis does for xi (figures 4.2, 4.6).
#pragma once

#include <vector>

#include "calibration/fit_problem.hpp"

namespace fiberfate {

/// The average error of predictions, per cent: the mean of |predicted - observed|/observed over all
/// observations that are not zero (thesis 4.7, 4.8); NaN when all are.
[[nodiscard]] double average_error_percent(std::span<const double> observed,
                                           std::span<const double> predicted);

/// Which values to try; the other parameters stay at `values`.
struct SweepRequest {
  std::size_t parameter = 0;
  double lower = 0;
  double upper = 0;
  std::size_t count = 50;
  ParameterScale spacing = ParameterScale::logarithmic;
};

/// The values of a request, rising. Raises InputError as `sweep`.
[[nodiscard]] std::vector<double> swept_values(const SweepRequest& request);

/// A scan.
struct Sweep {
  std::vector<double> values;
  std::vector<double> errors;                      ///< average error of all observations, %
  std::vector<std::vector<double>> series_errors;  ///< [series][value], %
  double best_value = 0;                           ///< refined between the values next to the least one
  double best_error = 0;                           ///< %
};

/// Scans `count` values (at least 3) between the bounds of the request and refines the least error to 1e-6 of
/// the value. Raises InputError for bounds out of order or, with logarithmic spacing, not positive.
[[nodiscard]] Sweep sweep(const FitProblem& problem, std::span<const double> values,
                          const SweepRequest& request);

}  // namespace fiberfate
