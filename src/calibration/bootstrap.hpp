// Finds confidence intervals by fitting again to data as they might have come out.
#pragma once

#include <cstdint>
#include <vector>

#include "calibration/fit.hpp"

namespace fiberfate {

/// Chooses how data are made anew.
enum class BootstrapKind {
  residuals,  ///< predictions plus residuals drawn with replacement, enlarged by sqrt(n/df)
  normal      ///< predictions plus normal noise of the fit's scale
};

/// How many samples to draw.
struct BootstrapOptions {
  int samples = 500;
  BootstrapKind kind = BootstrapKind::residuals;
  std::uint64_t seed = 1;
  double level = 0.95;
};

/// What the samples gave, by free parameter.
struct Bootstrap {
  std::vector<std::vector<double>> values;  ///< [free parameter][sample], SI, of the samples that converged
  std::vector<double> standard_errors;
  std::vector<ConfidenceInterval> intervals;  ///< between percentiles
  int failed = 0;                             ///< samples that did not converge
};

/// Repeats a fit with data made anew. Raises InputError without degrees of freedom, where there are no
/// residuals to draw. The same seed gives the same samples for any number of threads. Source: Efron,
/// Tibshirani, An Introduction to the Bootstrap (1993), chapter 9.
[[nodiscard]] Bootstrap bootstrap(const FitProblem& problem, const FitResult& fit,
                                  const BootstrapOptions& options);

}  // namespace fiberfate
