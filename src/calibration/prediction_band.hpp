// The uncertainty of a fitted model's predictions.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "calibration/fit.hpp"

namespace fiberfate {

/// Predictions with the band in which the model's true curve lies, and the wider one of a new
/// observation.
struct PredictionBand {
  std::vector<double> predicted;
  std::vector<ConfidenceInterval> curve;  ///< confidence band of the mean
  std::vector<ConfidenceInterval>
      observation;  ///< prediction band: curve and noise of one observation together
};

/// What to predict: `count` numbers from all parameters (SI), each with the uncertainty that an
/// observation of it would have (as FitSeries::uncertainty; its scale is that of the fit).
struct PredictionRequest {
  FitModel model;
  std::vector<double> uncertainty;  ///< as many as there are predictions
};

/// Predicts with bands by linearisation: variance g^T C g with the gradient g of the prediction and the
/// covariance C of the parameters; pointwise, at `level`. NaN bands without degrees of freedom.
[[nodiscard]] PredictionBand predict_with_band(const FitProblem& problem, const FitResult& fit,
                                               const PredictionRequest& request, double level = 0.95);

}  // namespace fiberfate
