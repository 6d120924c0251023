// Checks a case of the study calibration.
#include "studies/calibration/case.hpp"
#include "studies/calibration/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/error.hpp"
#include "base/units.hpp"
#include "studies/calibration/data.hpp"
#include "studies/calibration/model.hpp"
#include "studies/pace.hpp"

namespace fiberfate {
namespace {

const LawParameter* parameter_named(const CalibrationCase& values, const std::string& name) {
  const LawMenuItem* law = chosen_law(calibrated_menu(values), calibrated_law(values));
  if (law == nullptr) return nullptr;
  for (const LawParameter& parameter : law->parameters)
    if (parameter.name == name) return &parameter;
  return nullptr;
}

void require_parameter(const CalibrationCase& values, const std::string& key, const std::string& name,
                       CaseChecker& checker) {
  const LawMenuItem* law = chosen_law(calibrated_menu(values), calibrated_law(values));
  if (law == nullptr || parameter_named(values, name) != nullptr) return;
  std::vector<std::string> names;
  for (const LawParameter& parameter : law->parameters) names.push_back(parameter.name);
  const std::string near = nearest_word(name, names);
  checker.error(key, fmt::format("the law {} has no parameter '{}'", law->name, name),
                near.empty() ? fmt::format("its parameters are {}", fmt::join(names, ", "))
                             : fmt::format("did you mean '{}'?", near));
}

void validate_choice_of_law(const CalibrationCase& values, CaseChecker& checker) {
  const bool attrition = !values.law.name.empty(), orientation = calibrates_orientation(values);
  if (attrition == orientation)
    checker.error(attrition ? "orientation.name" : "law.name",
                  attrition ? "two laws are given" : "no law is given",
                  "give a name under [law] or under [orientation]");
  validate_law(attrition_menu(), "law", values.law, checker);
  validate_law(orientation_menu(), "orientation", values.orientation, checker);
  if (attrition && !calibrates_in_molds(values) && values.conditions.viscosities.empty())
    validate_law(viscosity_menu(), "melt", values.melt, checker);
}

void validate_conditions(const CalibrationCase& values, CaseChecker& checker) {
  const CalibrationConditions& conditions = values.conditions;
  const std::size_t count = conditions.names.size();
  const auto check = [&](const char* key, std::size_t size) {
    if (size > 1 && size != count)
      checker.error(key, fmt::format("{} entries for {} conditions", size, count),
                    "give one for each, or one for all");
  };
  check("conditions.rates", conditions.rates.size());
  check("conditions.speeds", conditions.speeds.size());
  check("conditions.viscosities", conditions.viscosities.size());
  check("conditions.temperatures", conditions.temperatures.size());
  check("conditions.pressures", conditions.pressures.size());
  check("conditions.lengths", conditions.lengths.size());
  check("conditions.compressions", conditions.compressions.size());
  check("conditions.flows", conditions.flows.size());
  if (conditions.rates.empty() == conditions.speeds.empty() && !calibrates_in_molds(values))
    checker.error("conditions.rates",
                  conditions.rates.empty() ? "no shear rates are given" : "rates and speeds are given",
                  "give rates or speeds, or moldings");
  for (const std::string& flow : conditions.flows)
    if (flow != "shear" && flow != "planar" && flow != "uniaxial" && flow != "biaxial")
      checker.error("conditions.flows", fmt::format("there is no flow '{}'", flow),
                    "give shear, planar, uniaxial or biaxial");
  if (values.fibers.form == LengthForm::means && needs_bins(values.law))
    checker.error("fibers.form", laws_of_bins() + " follow distributions only",
                  "take form = \"distribution\"");
}

void validate_lengths(const CalibrationCase& values, CaseChecker& checker) {
  const LengthChoices& fibers = values.fibers;
  if (calibrates_orientation(values)) {
    checker.warn_unused(
        {"conditions.lengths", "fibers.distribution", "fibers.number_average", "fibers.weight_average"},
        "an attrition law");
    return;
  }
  const bool means = gives_means(fibers);
  const int given =
      (values.conditions.lengths.empty() ? 0 : 1) + (fibers.distribution.empty() ? 0 : 1) + (means ? 1 : 0);
  if (given != 1)
    checker.error(
        "conditions.lengths",
        given == 0 ? "not given; attrition starts from a length" : "lengths are given in more than one way",
        "give conditions.lengths = [\"15 mm\"], or fibers.distribution, or both mean lengths under [fibers]");
  if (means) validate_mean_lengths(fibers, checker);
  if (fibers.form == LengthForm::distribution) return;
  for (const std::vector<std::string>& row : values.data.series)
    if (row[1] == "histogram")
      checker.error("fibers.form", "means hold no histogram to compare with data.series",
                    "take form = \"distribution\"");
}

void validate_points(const CalibrationCase& values, CaseChecker& checker) {
  validate_lengths(values, checker);
  if (values.data.series.empty() && checker.is_sound("data.series"))
    checker.error("data.series", "not given", "add what was measured");
  checker.warn_unused({"data.lengths"}, "conditions.moldings");
}

void validate_search(const CalibrationCase& values, CaseChecker& checker) {
  for (const std::string& name : values.search.free) require_parameter(values, "fit.free", name, checker);
  for (const std::string& name : values.search.linear) require_parameter(values, "fit.linear", name, checker);
  for (const std::vector<std::string>& row : values.search.bounds) {
    require_parameter(values, "fit.bounds", row[0], checker);
    const LawParameter* parameter = parameter_named(values, row[0]);
    if (parameter == nullptr) continue;
    try {
      if (!(quantity_in_si(row[1], parameter->unit) < quantity_in_si(row[2], parameter->unit)))
        checker.error_in_row("fit.bounds", row[0], fmt::format("the bounds of {} are out of order", row[0]),
                             "swap them");
    } catch (const std::invalid_argument& problem) {
      checker.error_in_row("fit.bounds", row[0], fmt::format("{}: {}", row[0], problem.what()),
                           "give values with units");
    }
  }
  if (values.search.free.empty() && checker.is_sound("fit.free"))
    checker.error("fit.free", "no parameter is free", "name at least one");
}

void validate_sweep(const CalibrationCase& values, CaseChecker& checker) {
  const CalibrationSweep& sweep = values.sweep;
  if (sweep.parameter.empty()) {
    checker.warn_unused({"sweep.lower", "sweep.upper", "sweep.count", "sweep.spacing"},
                        "a given sweep.parameter");
    return;
  }
  require_parameter(values, "sweep.parameter", sweep.parameter, checker);
  if (sweep.lower && sweep.upper && !(*sweep.lower < *sweep.upper))
    checker.error("sweep.lower", "not less than " + checker.cite("sweep.upper"), "swap them");
  if (sweep.spacing == ParameterScale::logarithmic && sweep.lower && !(*sweep.lower > 0))
    checker.error("sweep.lower", "not above zero, where equal ratios begin",
                  "raise it, or take spacing = \"linear\"");
}

}  // namespace

const LawMenu& calibrated_menu(const CalibrationCase& values) {
  return calibrates_orientation(values) ? orientation_menu() : attrition_menu();
}

const LawChoice& calibrated_law(const CalibrationCase& values) {
  return calibrates_orientation(values) ? values.orientation : values.law;
}

void validate_calibration(const CalibrationCase& values, CaseChecker& checker) {
  validate_choice_of_law(values, checker);
  validate_conditions(values, checker);
  const bool molds = calibrates_in_molds(values);
  if (!molds) validate_points(values, checker);
  validate_search(values, checker);
  validate_sweep(values, checker);
  if (molds) validate_moldings(values, checker);
  if (!checker.is_sound() || (molds && checker.files_may_be_gone())) return;
  try {
    pose_calibration(values, read_measurements(values)).check();
  } catch (const InputError& error) {
    for (const InputProblem& problem : error.problems())
      if (problem.key == "data.series")
        checker.error_in_row(problem.key, problem.line - 1, problem.complaint, problem.remedy);
      else
        checker.error(molds ? "data.lengths" : "data.series", problem.complaint, problem.remedy);
  }
}

CaseEstimate estimate_calibration(const CalibrationCase& values) {
  CaseEstimate estimate;
  const std::vector<MeasuredSeries> series = read_measurements(values);
  std::size_t observations = 0;
  for (const MeasuredSeries& one : series) observations += one.values.size();
  estimate.facts = {{"observations", fmt::format("{}", observations)},
                    {"free parameters", fmt::format("{}", values.search.free.size())}};
  if (calibrates_in_molds(values)) return molded_estimate(values, std::move(estimate));
  for (std::size_t i = 0; i < values.conditions.names.size(); ++i) {
    const LengthFlow flow = condition_flow(values, i);
    estimate.facts.emplace_back(values.conditions.names[i],
                                fmt::format("{:.6g} 1/s, {:.6g} Pa s, {:.6g} Pa", flow.rate, flow.viscosity,
                                            flow.rate * flow.viscosity));
  }
  estimate.memory_bytes = 2e7;
  foretell(
      estimate, [&] { return calibration_seconds(values); }, "from a trial on this machine");
  return estimate;
}

}  // namespace fiberfate
