// Builds predictions of conditions from attrition and orientation laws.
#include "studies/calibration/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>

#include "base/error.hpp"
#include "base/units.hpp"
#include "continuum/length_prediction.hpp"
#include "continuum/length_registry.hpp"
#include "continuum/orientation_history.hpp"
#include "continuum/orientation_registry.hpp"
#include "studies/calibration/molds.hpp"

namespace fiberfate {
namespace {

constexpr double usual_temperature = 523.15;  // K: the melt of the thesis' experiments
/// Differences of the fit are taken over 1e-4: integration must be finer by far.
constexpr double integration_tolerance = 1e-11;

/// What is measured in one condition, ready to be predicted.
struct Condition {
  LengthFlow flow;
  LengthStart start;             ///< attrition
  Mat3 gradient = Mat3::Zero();  ///< orientation
  Mat3 orientation = Mat3::Identity() / 3;
  std::vector<double> times;  ///< all that any series wants, rising
};

/// Points from a series into the predictions and the times of its condition.
struct Slot {
  const MeasuredSeries* series;
  std::size_t begin;  ///< of its predictions
};

Mat3 gradient_of(const std::string& flow, ShearGradient shear) {
  if (flow == "planar") return planar_elongation_gradient();
  if (flow == "uniaxial") return uniaxial_elongation_gradient();
  if (flow == "biaxial") return biaxial_elongation_gradient();
  return shear_gradient(shear, 1);
}

std::vector<Condition> make_conditions(const CalibrationCase& values,
                                       const std::vector<MeasuredSeries>& series) {
  const CalibrationConditions& given = values.conditions;
  std::vector<Condition> conditions(given.names.size());
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    Condition& one = conditions[i];
    one.flow = condition_flow(values, i);
    one.start = length_start(condition_fibers(values, i));
    one.gradient = one.flow.rate * gradient_of(entry(given.flows, i, "shear"), given.shear_gradient);
    one.orientation = given.orientation;
  }
  for (const MeasuredSeries& one : series) {
    std::vector<double>& times = conditions[one.condition].times;
    times.insert(times.end(), one.times.begin(), one.times.end());
  }
  for (Condition& one : conditions) {
    std::sort(one.times.begin(), one.times.end());
    one.times.erase(std::unique(one.times.begin(), one.times.end()), one.times.end());
  }
  return conditions;
}

/// Calls visit(slot, index) for every value of the condition's series that is taken at this time.
template <class Visit>
void visit_values(const std::vector<Slot>& slots, std::size_t condition, double time, const Visit& visit) {
  for (const Slot& slot : slots) {
    if (slot.series->condition != condition) continue;
    for (std::size_t i = 0; i < slot.series->times.size(); ++i)
      if (slot.series->times[i] == time) visit(slot, i);
  }
}

double share_of_bin(const LengthClasses& population, const MeasuredSeries& series, std::size_t bin) {
  const double all = std::accumulate(population.numbers.begin(), population.numbers.end(), 0.0);
  return histogram(population, series.edges)[bin] / all;
}

double predict_length(const AttritionLaw& law, const Condition& condition, const LengthSample& sample,
                      const MeasuredSeries& series, std::size_t index) {
  switch (series.observed) {
    case Observed::number_average:
      return sample.evolution.means().number_average;
    case Observed::weight_average:
      return sample.evolution.means().weight_average;
    case Observed::final_length:
      return law.unbreakable_length(condition.flow);
    case Observed::rate_constant:
      return law.relaxation() == nullptr ? std::nan("") : law.relaxation()->at(condition.flow).rate_constant;
    case Observed::histogram:
      return share_of_bin(sample.evolution.population(), series, index);
    case Observed::orientation:
      break;
  }
  return std::nan("");
}

void predict_lengths(const AttritionLaw& law, const std::vector<Condition>& conditions,
                     const std::vector<Slot>& slots, std::span<double> predictions) {
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const Condition& condition = conditions[i];
    const FlowHistory history = FlowHistory::constant(simple_shear(condition.flow.rate));
    const auto viscosity = make_viscosity_law("newtonian", std::vector<double>{condition.flow.viscosity});
    follow_lengths(law, condition.start, {history, *viscosity, condition.flow.compression}, condition.times,
                   [&](const LengthSample& sample) {
                     visit_values(slots, i, sample.time, [&](const Slot& slot, std::size_t index) {
                       predictions[slot.begin + index] =
                           predict_length(law, condition, sample, *slot.series, index);
                     });
                   });
  }
}

void predict_orientation(const OrientationModel& model, const std::vector<Condition>& conditions,
                         const std::vector<Slot>& slots, std::span<double> predictions) {
  const OrientationLaw law(model);
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const Condition& condition = conditions[i];
    OrientationIntegrator integrator(law, FlowHistory::constant({condition.gradient}),
                                     {0, condition.orientation},
                                     {integration_tolerance, integration_tolerance});
    for (const double time : condition.times) {
      integrator.advance_to(time);
      visit_values(slots, i, time, [&](const Slot& slot, std::size_t index) {
        predictions[slot.begin + index] = integrator.state().second(slot.series->row, slot.series->column);
      });
    }
  }
}

OrientationModel orientation_model(const CalibrationCase& values, std::span<const double> parameters) {
  OrientationModel model = orientation_model_named(values.orientation.name, values.closure);
  const LawMenuItem& law = *chosen_law(orientation_menu(), values.orientation);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    set_constant(model, law.parameters[i].name, parameters[i]);
  return model;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

FitParameter fit_parameter(const CalibrationSearch& search, const LawParameter& parameter, double value) {
  FitParameter one = {parameter.name, parameter.unit, value, parameter.lower, parameter.upper};
  one.role = contains(search.free, parameter.name) ? ParameterRole::free : ParameterRole::fixed;
  one.scale = contains(search.linear, parameter.name) || value <= 0 ? ParameterScale::linear
                                                                    : ParameterScale::logarithmic;
  for (const std::vector<std::string>& row : search.bounds) {
    if (row[0] != parameter.name) continue;
    one.lower = quantity_in_si(row[1], parameter.unit);
    one.upper = quantity_in_si(row[2], parameter.unit);
  }
  return one;
}

/// The deviation of an observation at a time: interpolated, and that of the nearest one before the first and
/// after the last.
double deviation_at(const MeasuredSeries& series, double time) {
  std::map<double, double> known;
  for (std::size_t i = 0; i < series.times.size(); ++i) known[series.times[i]] = series.deviations[i];
  const auto after = known.lower_bound(time);
  if (after == known.end()) return known.rbegin()->second;
  if (after == known.begin()) return after->second;
  const auto before = std::prev(after);
  return std::lerp(before->second, after->second, (time - before->first) / (after->first - before->first));
}

}  // namespace

LengthChoices condition_fibers(const CalibrationCase& values, std::size_t condition) {
  LengthChoices fibers = values.fibers;
  const std::vector<double>& lengths = values.conditions.lengths;
  if (!lengths.empty() || calibrates_orientation(values)) fibers.length = entry(lengths, condition, 1e-3);
  return fibers;
}

LengthFlow condition_flow(const CalibrationCase& values, std::size_t condition) {
  const CalibrationConditions& given = values.conditions;
  LengthFlow flow;
  flow.rate = given.speeds.empty() ? entry(given.rates, condition, 0)
                                   : shear_rate(given.couette, entry(given.speeds, condition, 0));
  flow.compression = entry(given.compressions, condition, 1);
  if (!given.viscosities.empty()) {
    flow.viscosity = entry(given.viscosities, condition, 0);
  } else if (!calibrates_orientation(values)) {
    const auto melt = make_viscosity_law(values.melt.name, law_values(viscosity_menu(), values.melt));
    flow.viscosity = melt->at({flow.rate, entry(given.temperatures, condition, usual_temperature),
                               entry(given.pressures, condition, 0)});
  }
  return flow;
}

FitModel calibration_model(const CalibrationCase& values, const std::vector<MeasuredSeries>& series) {
  if (calibrates_in_molds(values)) return mold_model(values, series);
  struct Setup {
    CalibrationCase values;
    std::vector<MeasuredSeries> series;
    std::vector<Condition> conditions;
    std::vector<Slot> slots;
  };
  const auto setup = std::make_shared<Setup>();
  setup->values = values;
  setup->series = series;
  setup->conditions = make_conditions(values, series);
  std::size_t begin = 0;
  for (const MeasuredSeries& one : setup->series) {
    setup->slots.push_back({&one, begin});
    begin += one.values.size();
  }
  return [setup](std::span<const double> parameters, std::span<double> predictions) {
    if (calibrates_orientation(setup->values)) {
      predict_orientation(orientation_model(setup->values, parameters), setup->conditions, setup->slots,
                          predictions);
    } else {
      const auto law = make_attrition_law(setup->values.law.name, parameters);
      predict_lengths(*law, setup->conditions, setup->slots, predictions);
    }
  };
}

FitProblem pose_calibration(const CalibrationCase& values, const std::vector<MeasuredSeries>& series) {
  FitProblem problem;
  const LawMenuItem& law = *chosen_law(calibrated_menu(values), calibrated_law(values));
  const std::vector<double> start = law_values(calibrated_menu(values), calibrated_law(values));
  for (std::size_t i = 0; i < law.parameters.size(); ++i)
    problem.parameters.push_back(fit_parameter(values.search, law.parameters[i], start[i]));
  for (const MeasuredSeries& one : series)
    problem.series.push_back({one.name, one.unit, one.values, one.deviations});
  problem.model = calibration_model(values, series);
  problem.noise = values.data.noise;
  if (!calibrates_in_molds(values) || !feels_fibers(values, series)) return problem;
  // Between the coupled fillings lie splines, beyond them nothing.
  for (FitParameter& one : problem.parameters) {
    if (one.name != values.sweep.parameter) continue;
    one.lower = std::max(one.lower, values.sweep.lower.value_or(one.lower));
    one.upper = std::min(one.upper, values.sweep.upper.value_or(one.upper));
  }
  return problem;
}

MeasuredSeries refined(const MeasuredSeries& series, std::size_t count) {
  const bool single = series.observed == Observed::final_length || series.observed == Observed::rate_constant;
  if (single || series.observed == Observed::histogram || count < 2) return series;
  MeasuredSeries fine = series;
  fine.times.clear();
  fine.deviations.clear();
  const double end = *std::max_element(series.times.begin(), series.times.end());
  for (std::size_t i = 0; i < count; ++i) {
    fine.times.push_back(end * static_cast<double>(i) / static_cast<double>(count - 1));
    fine.deviations.push_back(deviation_at(series, fine.times.back()));
  }
  fine.values.assign(count, 0.0);
  return fine;
}

std::string remark_on_bins(const CalibrationCase& values, const std::vector<MeasuredSeries>& series,
                           const std::vector<double>& law_values) {
  constexpr double coarse = 0.01;
  if (calibrates_in_molds(values) || calibrates_orientation(values) || !needs_bins(values.law)) return {};
  const auto law = make_attrition_law(values.law.name, law_values);
  for (const MeasuredSeries& one : series) {
    const double length = law->unbreakable_length(condition_flow(values, one.condition));
    const LengthChoices fibers = condition_fibers(values, one.condition);
    if (std::string remark = remark_on_bins(fibers, length, coarse); !remark.empty()) return remark;
  }
  return {};
}

}  // namespace fiberfate
