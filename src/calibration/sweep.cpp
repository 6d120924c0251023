// Scans errors over one parameter and refines their minimum.
#include "calibration/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/number_checks.hpp"

namespace fiberfate {
namespace {

std::vector<double> all_observations(const FitProblem& problem) {
  std::vector<double> all;
  for (const FitSeries& series : problem.series)
    all.insert(all.end(), series.observed.begin(), series.observed.end());
  return all;
}

void check(const SweepRequest& request) {
  require_number("lower", request.lower, any_finite);
  require_number("upper", request.upper, any_finite);
  if (!(request.lower < request.upper))
    throw InputError("the bounds of the sweep are out of order", "swap them");
  if (request.spacing == ParameterScale::logarithmic && !(request.lower > 0))
    throw InputError("a logarithmic sweep begins at zero or below",
                     "begin above zero, or take linear spacing");
  if (request.count < 3) throw InputError("a sweep has fewer than three values", "take at least three");
}

/// Shrinks a bracket around a minimum by golden sections.
template <class Function>
double refine_minimum(double low, double high, const Function& error) {
  constexpr double golden = std::numbers::phi - 1;
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double at_left = error(left), at_right = error(right);
  // A minimum at zero has no size of its own: the bracket's stands for it.
  const double width = high - low;
  while (high - low > std::max(1e-6 * (std::abs(low) + std::abs(high)), 1e-9 * width)) {
    if (at_left < at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - golden * (high - low);
      at_left = error(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + golden * (high - low);
      at_right = error(right);
    }
  }
  return 0.5 * (low + high);
}

}  // namespace

double average_error_percent(std::span<const double> observed, std::span<const double> predicted) {
  require_same_size("predicted", predicted.size(), observed.size());
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    if (observed[i] == 0) continue;
    sum += std::abs((predicted[i] - observed[i]) / observed[i]);
    ++count;
  }
  return count > 0 ? 100 * sum / static_cast<double>(count) : std::nan("");
}

std::vector<double> swept_values(const SweepRequest& request) {
  check(request);
  std::vector<double> values;
  for (std::size_t i = 0; i < request.count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(request.count - 1);
    values.push_back(request.spacing == ParameterScale::logarithmic
                         ? request.lower * std::pow(request.upper / request.lower, part)
                         : std::lerp(request.lower, request.upper, part));
  }
  return values;
}

Sweep sweep(const FitProblem& problem, std::span<const double> values, const SweepRequest& request) {
  problem.check();
  require_same_size("values", values.size(), problem.parameters.size());
  require_number("parameter", static_cast<double>(request.parameter),
                 {.lower = 0, .upper = static_cast<double>(values.size()) - 1});
  const std::vector<double> observed = all_observations(problem);
  if (std::ranges::all_of(observed, [](double one) { return one == 0; }))
    throw InputError("all observations are zero, and no error relative to them exists",
                     "observe something else");
  std::vector<double> parameters(values.begin(), values.end());
  const auto predict = [&](double value) {
    parameters[request.parameter] = value;
    return problem.predict(parameters);
  };
  Sweep result;
  result.values = swept_values(request);
  result.series_errors.resize(problem.series.size());
  for (const double value : result.values) {
    const std::vector<double> predicted = predict(value);
    require_numbers("predicted", predicted, any_finite);
    result.errors.push_back(average_error_percent(observed, predicted));
    std::size_t begin = 0;
    for (std::size_t k = 0; k < problem.series.size(); ++k) {
      const std::size_t size = problem.series[k].observed.size();
      result.series_errors[k].push_back(average_error_percent(std::span(observed).subspan(begin, size),
                                                              std::span(predicted).subspan(begin, size)));
      begin += size;
    }
  }
  const auto least = std::min_element(result.errors.begin(), result.errors.end()) - result.errors.begin();
  const auto at = static_cast<std::size_t>(least);
  const double low = result.values[at > 0 ? at - 1 : 0];
  const double high = result.values[std::min(at + 1, request.count - 1)];
  const auto error = [&](double value) { return average_error_percent(observed, predict(value)); };
  result.best_value = refine_minimum(low, high, error);
  result.best_error = error(result.best_value);
  if (result.errors[at] < result.best_error) {
    result.best_value = result.values[at];
    result.best_error = result.errors[at];
  }
  return result;
}

}  // namespace fiberfate
