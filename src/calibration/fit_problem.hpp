// Describes what is to be calibrated: parameters, observed series, and the model that predicts them.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace fiberfate {

/// Chooses in which coordinate a parameter is searched; `logarithmic` suits positive parameters of unknown
/// magnitude.
enum class ParameterScale { linear, logarithmic };
/// Chooses whether a parameter is searched or kept at its initial value.
enum class ParameterRole { free, fixed };

/// Describes one parameter of a model, in SI.
struct FitParameter {
  std::string name;
  std::string unit = "1";
  double initial = 0;
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  ParameterScale scale = ParameterScale::linear;
  ParameterRole role = ParameterRole::free;
};

/// Observations of one kind under one condition.
struct FitSeries {
  std::string name;
  std::string unit = "1";
  std::vector<double> observed;
  /// One standard deviation of each observation, positive: weights are 1/uncertainty^2. Whether their common
  /// scale is trusted is up to NoiseScale.
  std::vector<double> uncertainty;
};

/// Chooses what the uncertainties of the series mean.
enum class NoiseScale {
  estimated,  ///< only relative: the residuals tell the common scale, s^2 = chi^2/degrees of freedom
  known       ///< absolute
};

/// Predicts all series, one after another, from all parameters (fixed ones included, in SI, in order). It may
/// throw or write NaN where it cannot; the search then turns back.
using FitModel = std::function<void(std::span<const double> parameters, std::span<double> predictions)>;

/// A complete problem of weighted least squares.
struct FitProblem {
  std::vector<FitParameter> parameters;
  std::vector<FitSeries> series;
  FitModel model;
  NoiseScale noise = NoiseScale::estimated;

  /// How many observations the series hold.
  [[nodiscard]] std::size_t observation_count() const;
  /// Gives the indices of the free parameters.
  [[nodiscard]] std::vector<std::size_t> free_parameters() const;
  /// Gives the initial values of all parameters.
  [[nodiscard]] std::vector<double> initial_values() const;
  /// Predicts all series.
  [[nodiscard]] std::vector<double> predict(std::span<const double> parameters) const;
  /// Raises InputError that names what is wrong: no free parameter, an initial value outside its bounds, a
  /// logarithmic parameter that is not positive, series of unequal sizes, uncertainties that are not
  /// positive.
  void check() const;
};

/// Maps free parameters between their values and the coordinates of the search: logarithms for logarithmic
/// ones, values over a typical size for linear ones, so that a unit step means a similar change for all.
class FitCoordinates {
 public:
  explicit FitCoordinates(const FitProblem& problem);

  [[nodiscard]] std::size_t size() const { return free_.size(); }
  [[nodiscard]] std::size_t parameter(std::size_t coordinate) const { return free_[coordinate]; }
  [[nodiscard]] double to_coordinate(std::size_t coordinate, double value) const;
  [[nodiscard]] double to_value(std::size_t coordinate, double position) const;
  /// d value/d position.
  [[nodiscard]] double slope(std::size_t coordinate, double value) const;
  /// Writes the values at `positions` into `parameters`, which holds all parameters.
  void apply(std::span<const double> positions, std::span<double> parameters) const;
  [[nodiscard]] std::vector<double> positions(std::span<const double> parameters) const;
  [[nodiscard]] const std::vector<double>& lower() const { return lower_; }
  [[nodiscard]] const std::vector<double>& upper() const { return upper_; }

 private:
  std::vector<std::size_t> free_;
  std::vector<ParameterScale> scales_;
  std::vector<double> sizes_;
  std::vector<double> lower_;
  std::vector<double> upper_;
};

}  // namespace fiberfate
