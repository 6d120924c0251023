// Turns a calibration problem into residuals over the coordinates of the search.
#pragma once

#include <span>
#include <vector>

#include "calibration/fit_problem.hpp"
#include "calibration/least_squares.hpp"

namespace fiberfate {

/// What turns a position into weighted residuals (predicted - observed)/uncertainty. It refers to the
/// problem, which must live longer; parameters that are not free keep the values given here.
class WeightedResiduals {
 public:
  WeightedResiduals(const FitProblem& problem, std::span<const double> values);

  [[nodiscard]] const FitCoordinates& coordinates() const { return coordinates_; }
  [[nodiscard]] std::vector<double> observed() const { return observed_; }
  /// Replaces the observations, as a bootstrap does.
  void observe(std::span<const double> observed);
  /// Poses the least-squares problem over all coordinates; refers to this object.
  [[nodiscard]] LeastSquares pose(int most_iterations) const;
  /// Poses it with one coordinate held at a position (a profile); that coordinate then is not among the
  /// others.
  [[nodiscard]] LeastSquares pose_without(std::size_t coordinate, double held, int most_iterations) const;
  /// Computes the residuals; returns false where the model throws or gives what is not a number.
  bool compute(std::span<const double> position, std::span<double> residuals) const;

 private:
  const FitProblem& problem_;
  FitCoordinates coordinates_;
  std::vector<double> values_;
  std::vector<double> observed_;
  std::vector<double> uncertainty_;
};

}  // namespace fiberfate
