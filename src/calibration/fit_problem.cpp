// Checks calibration problems and maps their parameters to coordinates of the search.
#include "calibration/fit_problem.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"

namespace fiberfate {
namespace {

void check_parameter(const FitParameter& parameter) {
  const auto refuse = [&](const char* complaint, const char* remedy) {
    throw InputError(fmt::format("parameter {}: {}", parameter.name, complaint), remedy);
  };
  if (!std::isfinite(parameter.initial)) refuse("has no initial value", "give one");
  if (parameter.role == ParameterRole::fixed) return;
  if (std::isnan(parameter.lower) || std::isnan(parameter.upper))
    refuse("has a bound that is not a number", "give a number, or infinity for none");
  if (!(parameter.lower < parameter.upper))
    refuse("has a lower bound that is not below the upper one", "swap them");
  if (parameter.initial < parameter.lower || parameter.initial > parameter.upper)
    refuse("starts outside of its bounds", "move the initial value or the bounds");
  if (parameter.scale == ParameterScale::logarithmic && !(parameter.initial > 0))
    refuse("is logarithmic and not positive", "take a linear scale or a positive initial value");
}

void check_series(const FitSeries& series) {
  if (series.observed.empty())
    throw InputError(fmt::format("series {} has no observations", series.name), "give some");
  if (series.uncertainty.size() != series.observed.size())
    throw InputError(fmt::format("series {} has not one uncertainty an observation", series.name),
                     "give one for each");
  for (std::size_t i = 0; i < series.observed.size(); ++i) {
    if (!std::isfinite(series.observed[i]))
      throw InputError(fmt::format("series {} has an observation that is not a number", series.name),
                       "remove it");
    if (!(series.uncertainty[i] > 0) || !std::isfinite(series.uncertainty[i]))
      throw InputError(fmt::format("series {} has an uncertainty that is not positive", series.name),
                       "give one standard deviation; a relative one fails where the observation is zero");
  }
}

}  // namespace

std::size_t FitProblem::observation_count() const {
  std::size_t count = 0;
  for (const FitSeries& one : series) count += one.observed.size();
  return count;
}

std::vector<std::size_t> FitProblem::free_parameters() const {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].role == ParameterRole::free) indices.push_back(i);
  return indices;
}

std::vector<double> FitProblem::initial_values() const {
  std::vector<double> values;
  for (const FitParameter& parameter : parameters) values.push_back(parameter.initial);
  return values;
}

std::vector<double> FitProblem::predict(std::span<const double> values) const {
  std::vector<double> predictions(observation_count());
  model(values, predictions);
  return predictions;
}

void FitProblem::check() const {
  if (!model) throw InputError("there is no model to fit", "give one");
  if (free_parameters().empty()) throw InputError("no parameter is free", "free at least one");
  if (series.empty()) throw InputError("there is nothing to fit", "give at least one series");
  for (const FitParameter& parameter : parameters) check_parameter(parameter);
  for (const FitSeries& one : series) check_series(one);
}

FitCoordinates::FitCoordinates(const FitProblem& problem) : free_(problem.free_parameters()) {
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const FitParameter& parameter = problem.parameters[free_[i]];
    scales_.push_back(parameter.scale);
    const double range = parameter.upper - parameter.lower;
    const double fallback = std::isfinite(range) ? 0.1 * range : 1.0;
    sizes_.push_back(parameter.initial != 0 ? std::abs(parameter.initial) : fallback);
    const bool logarithmic = parameter.scale == ParameterScale::logarithmic;
    const double floor =
        logarithmic && !(parameter.lower > 0) ? -std::numeric_limits<double>::infinity() : 0.0;
    lower_.push_back(floor != 0 ? floor : to_coordinate(i, parameter.lower));
    upper_.push_back(to_coordinate(i, parameter.upper));
  }
}

double FitCoordinates::to_coordinate(std::size_t coordinate, double value) const {
  return scales_[coordinate] == ParameterScale::logarithmic ? std::log(value) : value / sizes_[coordinate];
}

double FitCoordinates::to_value(std::size_t coordinate, double position) const {
  return scales_[coordinate] == ParameterScale::logarithmic ? std::exp(position)
                                                            : position * sizes_[coordinate];
}

double FitCoordinates::slope(std::size_t coordinate, double value) const {
  return scales_[coordinate] == ParameterScale::logarithmic ? value : sizes_[coordinate];
}

void FitCoordinates::apply(std::span<const double> positions, std::span<double> parameters) const {
  for (std::size_t i = 0; i < free_.size(); ++i) parameters[free_[i]] = to_value(i, positions[i]);
}

std::vector<double> FitCoordinates::positions(std::span<const double> parameters) const {
  std::vector<double> result(free_.size());
  for (std::size_t i = 0; i < free_.size(); ++i) result[i] = to_coordinate(i, parameters[free_[i]]);
  return result;
}

}  // namespace fiberfate
