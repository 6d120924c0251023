// Hands sums of squares to Ceres, which sees nothing but residuals and their differences.
#include "calibration/least_squares.hpp"

#include <Eigen/QR>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wshadow"
#include <ceres/cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <glog/logging.h>
#pragma GCC diagnostic pop

namespace fiberfate {
namespace {

constexpr double difference_step = 1e-4;

/// Differences f'(x) = sum w_k f(x + s_k h)/(12 h), exact for polynomials of fourth degree.
struct Stencil {
  std::array<int, 5> steps;
  std::array<double, 5> weights;
};
constexpr Stencil central = {{-2, -1, 1, 2, 0}, {1, -8, 8, -1, 0}};
constexpr Stencil forward = {{0, 1, 2, 3, 4}, {-25, 48, -36, 16, -3}};
constexpr Stencil backward = {{0, -1, -2, -3, -4}, {25, -48, 36, -16, 3}};

const Stencil& stencil_for(double position, double lower, double upper) {
  if (position - 2 * difference_step < lower) return forward;
  if (position + 2 * difference_step > upper) return backward;
  return central;
}

class DifferencedCost final : public ceres::CostFunction {
 public:
  explicit DifferencedCost(const LeastSquares& problem) : problem_(problem) {
    set_num_residuals(static_cast<int>(problem.residual_count));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.lower.size()));
  }
  bool Evaluate(const double* const* blocks, double* residuals, double** jacobians) const override {
    const std::span<const double> position(blocks[0], problem_.lower.size());
    if (!problem_.residuals(position, {residuals, problem_.residual_count})) return false;
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    Eigen::MatrixXd jacobian;
    if (!differentiate(problem_, position, jacobian)) return false;
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<RowMajor>(jacobians[0], jacobian.rows(), jacobian.cols()) = jacobian;
    return true;
  }

 private:
  const LeastSquares& problem_;
};

ceres::Solver::Options solver_options(const LeastSquares& problem) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = problem.most_iterations;
  options.function_tolerance = 1e-20;
  options.parameter_tolerance = 1e-13;
  options.gradient_tolerance = 1e-16;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  return options;
}

/// Makes one Gauss-Newton step from a minimum. The sum of squares, being flat there, locates it to 1e-8 only;
/// its gradient locates it to round-off. A step that is not small, leaves the bounds or climbs is not taken.
void polish(const LeastSquares& problem, LeastSquaresMinimum& minimum) {
  constexpr double largest_step = 1e-3;
  Eigen::VectorXd residuals(static_cast<Eigen::Index>(problem.residual_count));
  const auto compute = [&](const std::vector<double>& position) {
    return problem.residuals(position, {residuals.data(), problem.residual_count});
  };
  Eigen::MatrixXd jacobian;
  if (!differentiate(problem, minimum.position, jacobian) || !compute(minimum.position)) return;
  const Eigen::VectorXd step = jacobian.completeOrthogonalDecomposition().solve(residuals);
  if (!(step.norm() < largest_step)) return;
  std::vector<double> polished = minimum.position;
  for (std::size_t i = 0; i < polished.size(); ++i) {
    polished[i] -= step[static_cast<Eigen::Index>(i)];
    if (polished[i] < problem.lower[i] || polished[i] > problem.upper[i]) return;
  }
  if (!compute(polished) || residuals.squaredNorm() > minimum.sum_of_squares * (1 + 1e-12)) return;
  minimum.sum_of_squares = residuals.squaredNorm();
  minimum.position = std::move(polished);
}

}  // namespace

bool differentiate(const LeastSquares& problem, std::span<const double> position, Eigen::MatrixXd& jacobian) {
  const auto rows = static_cast<Eigen::Index>(problem.residual_count);
  jacobian.setZero(rows, static_cast<Eigen::Index>(position.size()));
  std::vector<double> moved(position.begin(), position.end());
  Eigen::VectorXd residuals(rows);
  for (std::size_t i = 0; i < position.size(); ++i) {
    const Stencil& stencil = stencil_for(position[i], problem.lower[i], problem.upper[i]);
    for (std::size_t k = 0; k < stencil.steps.size(); ++k) {
      if (stencil.weights[k] == 0) continue;
      moved[i] = position[i] + stencil.steps[k] * difference_step;
      if (!problem.residuals(moved, {residuals.data(), problem.residual_count})) return false;
      jacobian.col(static_cast<Eigen::Index>(i)) += stencil.weights[k] / (12 * difference_step) * residuals;
    }
    moved[i] = position[i];
  }
  return true;
}

LeastSquaresMinimum minimise(const LeastSquares& problem, std::span<const double> start) {
  LeastSquaresMinimum minimum;
  minimum.position.assign(start.begin(), start.end());
  std::vector<double> residuals(problem.residual_count);
  if (!problem.residuals(start, residuals)) {
    minimum.sum_of_squares = std::numeric_limits<double>::infinity();
    minimum.message = "the model fails at the start";
    return minimum;
  }
  ceres::Problem ceres_problem;
  ceres_problem.AddResidualBlock(new DifferencedCost(problem), nullptr, minimum.position.data());
  for (std::size_t i = 0; i < start.size(); ++i) {
    const int index = static_cast<int>(i);
    if (std::isfinite(problem.lower[i]))
      ceres_problem.SetParameterLowerBound(minimum.position.data(), index, problem.lower[i]);
    if (std::isfinite(problem.upper[i]))
      ceres_problem.SetParameterUpperBound(minimum.position.data(), index, problem.upper[i]);
  }
  // A search that turns back from where the model fails is no error; Ceres would print each on the terminal.
  FLAGS_minloglevel = google::GLOG_FATAL;
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options(problem), &ceres_problem, &summary);
  minimum.sum_of_squares = 2 * summary.final_cost;
  minimum.converged = summary.termination_type == ceres::CONVERGENCE;
  minimum.iterations = static_cast<int>(summary.iterations.size());
  minimum.message = summary.message;
  if (minimum.converged) polish(problem, minimum);
  return minimum;
}

}  // namespace fiberfate
