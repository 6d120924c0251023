// Computes weighted residuals.
#include "calibration/weighted_residuals.hpp"

#include <cmath>
#include <exception>

namespace fiberfate {

WeightedResiduals::WeightedResiduals(const FitProblem& problem, std::span<const double> values)
    : problem_(problem), coordinates_(problem), values_(values.begin(), values.end()) {
  for (const FitSeries& series : problem.series) {
    observed_.insert(observed_.end(), series.observed.begin(), series.observed.end());
    uncertainty_.insert(uncertainty_.end(), series.uncertainty.begin(), series.uncertainty.end());
  }
}

void WeightedResiduals::observe(std::span<const double> observed) {
  observed_.assign(observed.begin(), observed.end());
}

bool WeightedResiduals::compute(std::span<const double> position, std::span<double> residuals) const {
  std::vector<double> parameters = values_;
  coordinates_.apply(position, parameters);
  try {
    problem_.model(parameters, residuals);
  } catch (const std::exception&) {
    // The search has strayed to where the model does not hold; the initial values were checked before.
    return false;
  }
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    residuals[i] = (residuals[i] - observed_[i]) / uncertainty_[i];
    if (!std::isfinite(residuals[i])) return false;
  }
  return true;
}

LeastSquares WeightedResiduals::pose(int most_iterations) const {
  return {[this](std::span<const double> position, std::span<double> residuals) {
            return compute(position, residuals);
          },
          observed_.size(), coordinates_.lower(), coordinates_.upper(), most_iterations};
}

LeastSquares WeightedResiduals::pose_without(std::size_t coordinate, double held, int most_iterations) const {
  LeastSquares problem = pose(most_iterations);
  const auto at = static_cast<std::ptrdiff_t>(coordinate);
  problem.lower.erase(problem.lower.begin() + at);
  problem.upper.erase(problem.upper.begin() + at);
  problem.residuals = [this, at, held](std::span<const double> others, std::span<double> residuals) {
    std::vector<double> position(others.begin(), others.end());
    position.insert(position.begin() + at, held);
    return compute(position, residuals);
  };
  return problem;
}

}  // namespace fiberfate
