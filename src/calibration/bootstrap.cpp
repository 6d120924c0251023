// Draws bootstrap samples and fits each.
#include "calibration/bootstrap.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "base/random.hpp"
#include "calibration/weighted_residuals.hpp"

namespace fiberfate {
namespace {

std::vector<double> all_uncertainties(const FitProblem& problem) {
  std::vector<double> all;
  for (const FitSeries& series : problem.series)
    all.insert(all.end(), series.uncertainty.begin(), series.uncertainty.end());
  return all;
}

/// Weighted residuals, centred and enlarged to the noise that the fit has absorbed.
std::vector<double> drawable_residuals(const std::vector<double>& observed,
                                       const std::vector<double>& uncertainty, const FitResult& fit) {
  std::vector<double> residuals(observed.size());
  double mean = 0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    residuals[i] = (observed[i] - fit.predictions[i]) / uncertainty[i];
    mean += residuals[i] / static_cast<double>(residuals.size());
  }
  const double enlarge =
      std::sqrt(static_cast<double>(residuals.size()) / static_cast<double>(fit.degrees_of_freedom));
  for (double& residual : residuals) residual = enlarge * (residual - mean);
  return residuals;
}

ConfidenceInterval percentile_interval(std::vector<double> values, double level) {
  if (values.empty()) return {std::nan(""), std::nan("")};
  std::sort(values.begin(), values.end());
  const auto quantile = [&](double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return std::lerp(values[below], values[above], place - static_cast<double>(below));
  };
  return {quantile(0.5 * (1 - level)), quantile(0.5 * (1 + level))};
}

double standard_deviation(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  double mean = 0, sum = 0;
  for (const double value : values) mean += value / count;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / (count - 1));
}

}  // namespace

Bootstrap bootstrap(const FitProblem& problem, const FitResult& fit, const BootstrapOptions& options) {
  require_number("level", options.level, {.lower = 0, .upper = 1 - 1e-12, .above_lower = true});
  require_number("samples", options.samples, {.lower = 2});
  require_same_size("predictions", fit.predictions.size(), problem.observation_count());
  if (fit.degrees_of_freedom <= 0)
    throw InputError("a fit without degrees of freedom cannot be bootstrapped",
                     "observe more, or fix parameters");
  WeightedResiduals residuals(problem, fit.values);
  const FitCoordinates& coordinates = residuals.coordinates();
  const std::vector<double> observed = residuals.observed();
  const std::vector<double> uncertainty = all_uncertainties(problem);
  const std::vector<double> drawable = drawable_residuals(observed, uncertainty, fit);
  const std::vector<double> best = coordinates.positions(fit.values);

  Bootstrap result;
  result.values.resize(coordinates.size());
  std::vector<double> sample(observed.size());
  for (int number = 0; number < options.samples; ++number) {
    for (std::size_t i = 0; i < sample.size(); ++i) {
      const RandomCounter counter = {static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(i)};
      const double drawn =
          options.kind == BootstrapKind::normal
              ? fit.noise_scale * normal2(options.seed, RandomStream::bootstrap, counter)[0]
              : drawable[static_cast<std::size_t>(uniform(options.seed, RandomStream::bootstrap, counter) *
                                                  static_cast<double>(drawable.size()))];
      sample[i] = fit.predictions[i] + uncertainty[i] * drawn;
    }
    residuals.observe(sample);
    const LeastSquaresMinimum minimum = minimise(residuals.pose(200), best);
    if (!minimum.converged) {
      ++result.failed;
      continue;
    }
    for (std::size_t i = 0; i < coordinates.size(); ++i)
      result.values[i].push_back(coordinates.to_value(i, minimum.position[i]));
  }
  for (const std::vector<double>& values : result.values) {
    result.standard_errors.push_back(standard_deviation(values));
    result.intervals.push_back(percentile_interval(values, options.level));
  }
  return result;
}

}  // namespace fiberfate
