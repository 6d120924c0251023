// Searches the minimum of a calibration problem and derives errors, correlations and findings from its
// Jacobian.
#include "calibration/fit.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "base/random.hpp"
#include "calibration/least_squares.hpp"
#include "calibration/student.hpp"
#include "calibration/weighted_residuals.hpp"

namespace fiberfate {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
/// Singular values below this share of the largest are zero: differences are accurate to about 1e-10.
constexpr double rank_tolerance = 1e-7;
/// A parameter takes part in a combination when its component exceeds this.
constexpr double part_tolerance = 1e-3;
constexpr double strong_correlation = 0.99;

/// Draws the place of another start: anywhere between the bounds; where one is open, one unit of the search
/// away at most.
std::vector<double> other_start(const FitCoordinates& coordinates, std::span<const double> first, int number,
                                std::uint64_t seed) {
  std::vector<double> start(first.begin(), first.end());
  for (std::size_t i = 0; i < start.size(); ++i) {
    const double lower = coordinates.lower()[i], upper = coordinates.upper()[i];
    const double low = std::isfinite(lower) ? lower : first[i] - 1;
    const double high = std::isfinite(upper) ? upper : first[i] + 1;
    const RandomCounter counter = {static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(i)};
    start[i] = low + (high - low) * uniform(seed, RandomStream::noise, counter);
  }
  return start;
}

LeastSquaresMinimum search(const WeightedResiduals& residuals, const FitOptions& options, FitResult& result) {
  const LeastSquares problem = residuals.pose(options.most_iterations);
  const std::vector<double> first = residuals.coordinates().positions(result.values);
  LeastSquaresMinimum best = minimise(problem, first);
  std::vector<double> sums = {best.sum_of_squares};
  for (int i = 1; i < options.starts; ++i) {
    LeastSquaresMinimum other =
        minimise(problem, other_start(residuals.coordinates(), first, i, options.seed));
    sums.push_back(other.sum_of_squares);
    if (other.converged && other.sum_of_squares < best.sum_of_squares) best = std::move(other);
  }
  result.starts = options.starts;
  const double limit = best.sum_of_squares * (1 + 1e-6) + 1e-20;
  result.agreeing_starts =
      static_cast<int>(std::count_if(sums.begin(), sums.end(), [limit](double sum) { return sum <= limit; }));
  return best;
}

bool at_bound(const FitCoordinates& coordinates, std::size_t i, double position) {
  constexpr double near = 1e-9;
  return position - coordinates.lower()[i] < near || coordinates.upper()[i] - position < near;
}

/// States a direction of the search that changes no prediction: relative changes of the parameters that take
/// part.
std::string describe_combination(const FitProblem& problem, const FitCoordinates& coordinates,
                                 const Eigen::VectorXd& direction) {
  const double largest = direction.cwiseAbs().maxCoeff();
  std::string text;
  for (Eigen::Index i = 0; i < direction.size(); ++i) {
    const double part = direction[i] / largest;
    if (std::abs(part) < part_tolerance) continue;
    const std::string& name = problem.parameters[coordinates.parameter(i)].name;
    text += fmt::format("{}{} by {:+.3g} %", text.empty() ? "" : " with ", name, part);
  }
  return text;
}

struct Linearisation {
  Eigen::MatrixXd inverse;                ///< pseudo-inverse of J^T J in the coordinates of the search
  std::vector<std::string> combinations;  ///< what the data do not determine
  std::vector<bool> undetermined;         ///< by coordinate
  Eigen::Index rank = 0;
};

Linearisation linearise(const FitProblem& problem, const FitCoordinates& coordinates,
                        Eigen::MatrixXd jacobian, const std::vector<bool>& bound) {
  const Eigen::Index count = jacobian.cols();
  Linearisation linear;
  linear.undetermined.assign(count, false);
  for (Eigen::Index i = 0; i < count; ++i)
    if (bound[i]) jacobian.col(i).setZero();
  // More rows than columns, so that directions which no observation sees have singular vectors too.
  Eigen::MatrixXd tall = Eigen::MatrixXd::Zero(std::max(jacobian.rows(), count), count);
  tall.topRows(jacobian.rows()) = jacobian;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(tall, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& singular = svd.singularValues();
  linear.inverse = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::VectorXd direction = svd.matrixV().col(k);
    if (singular[k] > rank_tolerance * singular[0]) {
      linear.inverse += direction * direction.transpose() / (singular[k] * singular[k]);
      ++linear.rank;
      continue;
    }
    double bound_part = 0;
    for (Eigen::Index i = 0; i < count; ++i)
      if (bound[i]) bound_part += direction[i] * direction[i];
    if (bound_part > 0.5) continue;
    linear.combinations.push_back(describe_combination(problem, coordinates, direction));
    for (Eigen::Index i = 0; i < count; ++i)
      if (std::abs(direction[i]) > part_tolerance) linear.undetermined[i] = true;
  }
  return linear;
}

void estimate_noise(const FitProblem& problem, Eigen::Index rank, FitResult& result) {
  result.degrees_of_freedom =
      static_cast<std::ptrdiff_t>(problem.observation_count()) - static_cast<std::ptrdiff_t>(rank);
  if (problem.noise == NoiseScale::known) {
    result.noise_scale = 1;
  } else {
    result.noise_scale = result.degrees_of_freedom > 0
                             ? std::sqrt(result.chi_square / static_cast<double>(result.degrees_of_freedom))
                             : not_a_number;
  }
}

void fill_matrices(const FitCoordinates& coordinates, const Linearisation& linear, FitResult& result) {
  const double variance = result.noise_scale * result.noise_scale;
  result.position_covariance = variance * linear.inverse;
  const auto count = static_cast<Eigen::Index>(coordinates.size());
  Eigen::VectorXd slopes(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    slopes[i] = coordinates.slope(i, result.values[coordinates.parameter(i)]);
  }
  result.covariance = slopes.asDiagonal() * result.position_covariance * slopes.asDiagonal();
  const Eigen::VectorXd deviations = linear.inverse.diagonal().cwiseSqrt();
  result.correlation = Eigen::MatrixXd::Identity(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index k = 0; k < count; ++k)
      if (i != k) result.correlation(i, k) = linear.inverse(i, k) / (deviations[i] * deviations[k]);
}

void fill_estimates(const FitProblem& problem, const FitCoordinates& coordinates, const Linearisation& linear,
                    const std::vector<bool>& bound, double level, FitResult& result) {
  const double freedom =
      problem.noise == NoiseScale::known ? infinity : static_cast<double>(result.degrees_of_freedom);
  const double quantile = student_quantile(level, freedom);
  for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
    const FitParameter& parameter = problem.parameters[i];
    const double value = result.values[i];
    result.parameters.push_back(
        {parameter.name, parameter.unit, value, 0.0, {value, value}, ParameterOutcome::fixed});
  }
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    ParameterEstimate& estimate = result.parameters[coordinates.parameter(i)];
    estimate.outcome = ParameterOutcome::determined;
    const auto at = static_cast<Eigen::Index>(i);
    double deviation = std::sqrt(result.position_covariance(at, at));
    if (linear.undetermined[i]) {
      estimate.outcome = ParameterOutcome::unidentifiable;
      deviation = infinity;
    } else if (bound[i]) {
      estimate.outcome = ParameterOutcome::at_bound;
      deviation = not_a_number;
    }
    estimate.standard_error = deviation * coordinates.slope(i, estimate.value);
    const double position = coordinates.to_coordinate(i, estimate.value);
    estimate.interval = {coordinates.to_value(i, position - quantile * deviation),
                         coordinates.to_value(i, position + quantile * deviation)};
  }
}

void find_correlations(const FitProblem& problem, const FitCoordinates& coordinates, FitResult& result) {
  for (Eigen::Index i = 0; i < result.correlation.rows(); ++i) {
    for (Eigen::Index k = 0; k < i; ++k) {
      const double correlation = result.correlation(i, k);
      if (!(std::abs(correlation) > strong_correlation)) continue;
      const auto name = [&](Eigen::Index at) { return problem.parameters[coordinates.parameter(at)].name; };
      result.findings.push_back({FindingKind::nearly_collinear,
                                 fmt::format("{} and {} are hardly told apart: their correlation is {:.4f}",
                                             name(k), name(i), correlation)});
    }
  }
}

void find_what_to_know(const FitProblem& problem, const FitCoordinates& coordinates,
                       const Linearisation& linear, FitResult& result) {
  const std::size_t observations = problem.observation_count();
  if (result.degrees_of_freedom <= 0)
    result.findings.push_back(
        {FindingKind::exactly_determined,
         fmt::format(
             "{} observations determine {} parameters exactly: the law passes through the data whatever they "
             "are, so they cannot test it, and no error can be estimated from them",
             observations, linear.rank)});
  for (const std::string& combination : linear.combinations)
    result.findings.push_back({FindingKind::unidentifiable,
                               "the data do not tell these parameters apart: changing " + combination +
                                   " changes no prediction; fix one of them or observe something else"});
  for (const ParameterEstimate& estimate : result.parameters)
    if (estimate.outcome == ParameterOutcome::at_bound)
      result.findings.push_back(
          {FindingKind::at_bound, fmt::format("{} ended at a bound, {:.6g} {}; its interval says nothing",
                                              estimate.name, estimate.value, estimate.unit)});
  find_correlations(problem, coordinates, result);
}

}  // namespace

void FitOptions::check() const {
  require_number("level", level, {.lower = 0, .upper = 1 - 1e-12, .above_lower = true});
  require_number("most_iterations", most_iterations, {.lower = 1});
  require_number("starts", starts, {.lower = 1});
}

FitResult fit(const FitProblem& problem, const FitOptions& options) {
  problem.check();
  options.check();
  FitResult result;
  result.values = problem.initial_values();
  // Outside of the search, so that what the model says about bad input reaches the user.
  for (const double prediction : problem.predict(result.values))
    if (!std::isfinite(prediction))
      throw InputError("the model gives no number at the initial values", "choose other initial values");

  const WeightedResiduals residuals(problem, result.values);
  const FitCoordinates& coordinates = residuals.coordinates();
  const LeastSquaresMinimum minimum = search(residuals, options, result);
  coordinates.apply(minimum.position, result.values);
  result.predictions = problem.predict(result.values);
  result.chi_square = minimum.sum_of_squares;
  result.converged = minimum.converged;
  result.iterations = minimum.iterations;
  if (!minimum.converged)
    result.findings.push_back({FindingKind::not_converged, "the search stopped: " + minimum.message});

  Eigen::MatrixXd jacobian;
  if (!differentiate(residuals.pose(options.most_iterations), minimum.position, jacobian))
    throw InputError("the model fails next to the best fit", "narrow the bounds of the parameters");
  std::vector<bool> bound;
  for (std::size_t i = 0; i < coordinates.size(); ++i)
    bound.push_back(at_bound(coordinates, i, minimum.position[i]));
  const Linearisation linear = linearise(problem, coordinates, jacobian, bound);
  estimate_noise(problem, linear.rank, result);
  fill_matrices(coordinates, linear, result);
  fill_estimates(problem, coordinates, linear, bound, options.level, result);
  find_what_to_know(problem, coordinates, linear, result);
  return result;
}

}  // namespace fiberfate
