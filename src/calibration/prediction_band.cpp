// Propagates the covariance of a fit to predictions.
#include "calibration/prediction_band.hpp"

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "calibration/least_squares.hpp"
#include "calibration/student.hpp"

namespace fiberfate {

PredictionBand predict_with_band(const FitProblem& problem, const FitResult& fit,
                                 const PredictionRequest& request, double level) {
  require_numbers("uncertainty", request.uncertainty, not_negative);
  require_same_size("values", fit.values.size(), problem.parameters.size());
  const FitCoordinates coordinates(problem);
  const auto predict = [&](std::span<const double> position, std::span<double> predictions) {
    std::vector<double> parameters = fit.values;
    coordinates.apply(position, parameters);
    request.model(parameters, predictions);
    return true;
  };
  const LeastSquares predictor = {predict, request.uncertainty.size(), coordinates.lower(),
                                  coordinates.upper(), 0};
  const std::vector<double> best = coordinates.positions(fit.values);
  PredictionBand band;
  band.predicted.resize(request.uncertainty.size());
  predict(best, band.predicted);
  Eigen::MatrixXd gradients;
  if (!differentiate(predictor, best, gradients))
    throw InputError("the model cannot be differentiated at the fit", "narrow the bounds of the parameters");
  const double freedom = problem.noise == NoiseScale::known ? std::numeric_limits<double>::infinity()
                                                            : static_cast<double>(fit.degrees_of_freedom);
  const double t = student_quantile(level, freedom);
  for (std::size_t i = 0; i < band.predicted.size(); ++i) {
    const Eigen::RowVectorXd gradient = gradients.row(static_cast<Eigen::Index>(i));
    const double variance = gradient * fit.position_covariance * gradient.transpose();
    const double noise = fit.noise_scale * request.uncertainty[i];
    const double curve = t * std::sqrt(variance), observation = t * std::sqrt(variance + noise * noise);
    band.curve.push_back({band.predicted[i] - curve, band.predicted[i] + curve});
    band.observation.push_back({band.predicted[i] - observation, band.predicted[i] + observation});
  }
  return band;
}

}  // namespace fiberfate
