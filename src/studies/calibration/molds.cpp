// Links the moldings of a calibration to its measured series.
#include "studies/calibration/molds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "calibration/natural_spline.hpp"
#include "calibration/sweep.hpp"
#include "studies/calibration/mold_experiment.hpp"

namespace fiberfate {
namespace {

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::size_t place_of(const MoldExperiment& experiment, const std::string& name) {
  const std::vector<NamedPlace>& places = experiment.places();
  const auto found = std::find_if(places.begin(), places.end(),
                                  [&name](const NamedPlace& place) { return place.name == name; });
  if (found == places.end()) throw InputError(fmt::format("there is no place \"{}\"", name), "");
  return found - places.begin();
}

/// One measured series, as its condition predicts it.
struct Link {
  std::size_t condition = 0, place = 0, samples = 0;
  LengthMean mean = LengthMean::number_average;
};

/// Predicts all series by the moldings of their conditions.
class MoldPredictor {
 public:
  MoldPredictor(const CalibrationCase& values, const std::vector<MeasuredSeries>& series);
  void predict(std::span<const double> parameters, std::span<double> predictions);

 private:
  /// Gives the length of every link of one condition.
  [[nodiscard]] std::vector<double> lengths(std::size_t condition, std::span<const double> parameters);
  /// Gives those of all moldings whose flow does not feel the fibers.
  [[nodiscard]] std::map<std::size_t, std::vector<double>> lengths_by_replay(
      std::span<const double> parameters);
  void sweep_coupled(std::size_t condition, std::span<const double> parameters);

  std::vector<Link> links_;
  std::map<std::size_t, MoldExperiment> experiments_;             ///< by condition
  std::map<std::size_t, std::vector<NaturalSpline>> logarithms_;  ///< of coupled ones, by link of theirs
  std::size_t swept_ = 0;                                         ///< number of the swept parameter
  std::vector<double> values_;                                    ///< of the sweep
  bool logarithmic_ = true;
};

MoldPredictor::MoldPredictor(const CalibrationCase& values, const std::vector<MeasuredSeries>& series) {
  for (const MeasuredSeries& one : series)
    if (!experiments_.contains(one.condition))
      experiments_.emplace(one.condition, MoldExperiment(molding_of(values, one.condition), values.law.name));
  for (const MeasuredSeries& one : series)
    links_.push_back(
        {one.condition, place_of(experiments_.at(one.condition), one.place), one.values.size(),
         one.observed == Observed::number_average ? LengthMean::number_average : LengthMean::weight_average});
  const CalibrationSweep& sweep = values.sweep;
  if (sweep.parameter.empty() || !sweep.lower || !sweep.upper) return;
  const std::vector<LawParameter>& parameters = chosen_law(attrition_menu(), values.law)->parameters;
  while (parameters[swept_].name != sweep.parameter) ++swept_;
  logarithmic_ = sweep.spacing == ParameterScale::logarithmic;
  SweepRequest request;
  request.lower = *sweep.lower;
  request.upper = *sweep.upper;
  request.count = sweep.count;
  request.spacing = sweep.spacing;
  values_ = swept_values(request);
}

std::vector<double> MoldPredictor::lengths(std::size_t condition, std::span<const double> parameters) {
  const std::vector<MeanLengths> means = experiments_.at(condition).predict(parameters);
  std::vector<double> lengths;
  for (const Link& link : links_)
    if (link.condition == condition) lengths.push_back(means[link.place].at(link.mean));
  return lengths;
}

void MoldPredictor::sweep_coupled(std::size_t condition, std::span<const double> parameters) {
  std::vector<double> at(parameters.begin(), parameters.end()), positions;
  std::vector<std::vector<double>> logarithms;
  for (const double value : values_) {
    at[swept_] = value;
    positions.push_back(logarithmic_ ? std::log(value) : value);
    const std::vector<double> lengths_here = lengths(condition, at);
    logarithms.resize(lengths_here.size());
    for (std::size_t i = 0; i < lengths_here.size(); ++i) logarithms[i].push_back(std::log(lengths_here[i]));
  }
  for (const std::vector<double>& one : logarithms) logarithms_[condition].emplace_back(positions, one);
}

std::map<std::size_t, std::vector<double>> MoldPredictor::lengths_by_replay(
    std::span<const double> parameters) {
  std::vector<std::size_t> conditions;
  for (const auto& [condition, experiment] : experiments_)
    if (!experiment.is_coupled()) conditions.push_back(condition);
  std::vector<std::vector<double>> found(conditions.size());
  // Fillings use all threads themselves, and only they may find that no melt comes to a place.
  const bool filled = std::all_of(conditions.begin(), conditions.end(), [this](std::size_t condition) {
    return experiments_.at(condition).fillings() > 0;
  });
  if (filled) {
    parallel_for(static_cast<std::ptrdiff_t>(conditions.size()),
                 [&](std::size_t at) { found[at] = lengths(conditions[at], parameters); });
  } else {
    for (std::size_t i = 0; i < conditions.size(); ++i) found[i] = lengths(conditions[i], parameters);
  }
  std::map<std::size_t, std::vector<double>> by_condition;
  for (std::size_t i = 0; i < conditions.size(); ++i) by_condition[conditions[i]] = std::move(found[i]);
  return by_condition;
}

void MoldPredictor::predict(std::span<const double> parameters, std::span<double> predictions) {
  std::map<std::size_t, std::vector<double>> found = lengths_by_replay(parameters);
  for (const auto& [condition, experiment] : experiments_) {
    if (!experiment.is_coupled()) continue;
    if (!logarithms_.contains(condition)) sweep_coupled(condition, parameters);
    const double position = logarithmic_ ? std::log(parameters[swept_]) : parameters[swept_];
    for (const NaturalSpline& spline : logarithms_[condition])
      found[condition].push_back(std::exp(spline.at(position)));
  }
  std::map<std::size_t, std::size_t> next;
  std::size_t at = 0;
  for (const Link& link : links_) {
    const double length = found[link.condition][next[link.condition]++];
    for (std::size_t i = 0; i < link.samples; ++i) predictions[at++] = length;
  }
}

}  // namespace

MoldingCase molding_of(const CalibrationCase& values, std::size_t condition) {
  MoldingCase molding = read_molding(entry(values.conditions.moldings, condition));
  const std::vector<double>& lengths = values.conditions.lengths;
  if (lengths.empty()) return molding;
  molding.fibers.distribution.clear();
  molding.fibers.number_average = molding.fibers.weight_average = std::nullopt;
  molding.fibers.length = entry(lengths, condition);
  return molding;
}

double inlet_length(const CalibrationCase& values, std::size_t condition) {
  const MoldingCase molding = molding_of(values, condition);
  const bool weight =
      std::none_of(values.data.lengths.begin(), values.data.lengths.end(), [&](const MoldedLengths& one) {
        return one.condition == values.conditions.names[condition] && one.mean == LengthMean::number_average;
      });
  if (molding.fibers.length) return *molding.fibers.length;
  MeanLengths means;
  if (molding.fibers.distribution.empty()) {
    means = {molding.fibers.number_average.value_or(0), molding.fibers.weight_average.value_or(0)};
  } else {
    means = mean_lengths(length_classes(molding.fibers.distribution));
  }
  return weight ? means.weight_average : means.number_average;
}

std::vector<MeasuredSeries> molded_series(const CalibrationCase& values) {
  std::vector<MeasuredSeries> all;
  const std::vector<std::string>& names = values.conditions.names;
  for (const MoldedLengths& row : values.data.lengths) {
    const auto condition = std::find(names.begin(), names.end(), row.condition);
    if (condition == names.end())
      throw InputError(fmt::format("there is no condition '{}'", row.condition),
                       fmt::format("conditions.names are {}", fmt::join(names, ", ")));
    MeasuredSeries series;
    series.name = fmt::format("{}: {} at {}", row.condition, symbol(row.mean), row.place);
    series.unit = std::string("m");  // gcc 12 warns falsely of a literal assigned here
    series.condition = condition - names.begin();
    series.observed = observed_mean(row.mean);
    series.place = row.place;
    series.values = row.samples;
    series.times.assign(row.samples.size(), 0.0);
    series.deviations.assign(row.samples.size(), values.data.relative_uncertainty * mean_of(row.samples));
    all.push_back(std::move(series));
  }
  return all;
}

FitModel mold_model(const CalibrationCase& values, const std::vector<MeasuredSeries>& series) {
  const auto predictor = std::make_shared<MoldPredictor>(values, series);
  return [predictor](std::span<const double> parameters, std::span<double> predictions) {
    predictor->predict(parameters, predictions);
  };
}

bool feels_fibers(const CalibrationCase& values, const std::vector<MeasuredSeries>& series) {
  return std::any_of(series.begin(), series.end(), [&values](const MeasuredSeries& one) {
    return molding_of(values, one.condition).fibers.coupling != CouplingChoice::none;
  });
}

FitProblem pooled(const FitProblem& problem) {
  FitProblem means = problem;
  for (FitSeries& one : means.series) {
    one.observed = {mean_of(one.observed)};
    one.uncertainty = {one.uncertainty.front()};
  }
  means.model = [all = problem](std::span<const double> parameters, std::span<double> predictions) {
    const std::vector<double> every = all.predict(parameters);
    std::size_t at = 0, next = 0;
    for (const FitSeries& one : all.series) {
      predictions[next++] = every[at];
      at += one.observed.size();
    }
  };
  return means;
}

}  // namespace fiberfate
