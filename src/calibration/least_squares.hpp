// Minimises a sum of squares within bounds, with Ceres.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace fiberfate {

/// Computes residuals at a position; returns false where it cannot.
using ResidualFunction = std::function<bool(std::span<const double> position, std::span<double> residuals)>;

/// A problem in the coordinates of the search: all of size one or so.
struct LeastSquares {
  ResidualFunction residuals;
  std::size_t residual_count = 0;
  std::vector<double> lower;
  std::vector<double> upper;
  int most_iterations = 200;
};

/// Where a search ended.
struct LeastSquaresMinimum {
  std::vector<double> position;
  double sum_of_squares = 0;
  bool converged = false;
  int iterations = 0;
  std::string message;  ///< why it stopped
};

/// Searches a minimum from `start` by Levenberg-Marquardt with projection on the bounds.
[[nodiscard]] LeastSquaresMinimum minimise(const LeastSquares& problem, std::span<const double> start);

/// Differentiates the residuals (rows) by the coordinates (columns) with differences of fourth order, step
/// 1e-4: central ones, or one-sided where a bound is nearer than two steps. Returns false where a residual
/// cannot be computed.
[[nodiscard]] bool differentiate(const LeastSquares& problem, std::span<const double> position,
                                 Eigen::MatrixXd& jacobian);

}  // namespace fiberfate
