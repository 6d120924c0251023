// Checks a case of the study orientation and makes from it what the laws take.
#include "studies/orientation/case.hpp"
#include "base/timer.hpp"
#include "studies/orientation/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "continuum/anisotropic_stress.hpp"
#include "continuum/fokker_planck.hpp"
#include "continuum/orientation_registry.hpp"
#include "keys/time_rows.hpp"
#include "microstructure/closure.hpp"
#include "microstructure/eigenframe.hpp"
#include "studies/pace.hpp"

namespace fiberfate {
namespace {

/// Intervals into which a ramp between two rows of the table is cut; the error falls with its square.
constexpr int ramp_pieces = 16;

template <class Row>
LawMenu menu_of(const std::vector<Row>& choices) {
  LawMenu menu;
  for (const Row& choice : choices) {
    LawMenuItem item{choice.name, choice.meaning, choice.source, {}};
    for (const std::string& name : choice.constants)
      for (const OrientationConstant& constant : orientation_constants())
        if (constant.parameter.name == name) item.parameters.push_back(constant.parameter);
    menu.push_back(std::move(item));
  }
  return menu;
}

void set_constants(OrientationModel& model, const LawMenu& menu, const LawChoice& choice) {
  const std::vector<double> values = law_values(menu, choice);
  const LawMenuItem& law = *chosen_law(menu, choice);
  for (std::size_t i = 0; i < values.size(); ++i) set_constant(model, law.parameters[i].name, values[i]);
}

Mat3 constant_gradient(const OrientationFlowChoices& flow) {
  const double rate = flow.rate.value_or(0);
  Mat3 shear = shear_gradient(flow.shear_gradient, rate);
  switch (flow.kind) {
    case OrientationFlow::planar:
      return rate * planar_elongation_gradient();
    case OrientationFlow::uniaxial:
      return rate * uniaxial_elongation_gradient();
    case OrientationFlow::biaxial:
      return rate * biaxial_elongation_gradient();
    case OrientationFlow::gradient:
      return row_gradient(flow.gradient.front(), 0);
    case OrientationFlow::mixed:
      shear(0, 0) = flow.elongation_rate.value_or(0);
      (flow.shear_gradient == ShearGradient::y ? shear(1, 1) : shear(2, 2)) = -shear(0, 0);
      return shear;
    default:
      return shear;
  }
}

void validate_flow(const OrientationFlowChoices& flow, CaseChecker& checker) {
  const std::string why = "this kind of flow needs it";
  const bool of_rate = flow.kind != OrientationFlow::gradient && flow.kind != OrientationFlow::table;
  if (of_rate)
    checker.require("flow.rate", why, "\"1 1/s\"");
  else
    checker.warn_unused({"flow.rate", "flow.shear_gradient"}, "the other kinds of flow");
  if (flow.kind == OrientationFlow::mixed)
    checker.require("flow.elongation_rate", why, "\"0.1 1/s\"");
  else
    checker.warn_unused({"flow.elongation_rate"}, "flow.kind = \"mixed\"");
  if (flow.kind == OrientationFlow::gradient) {
    checker.require("flow.gradient", why, "[[L11, L12, ... L33]]");
    if (flow.gradient.size() > 1)
      checker.error("flow.gradient", "more than one row", "for several gradients take kind = \"table\"");
  } else {
    checker.warn_unused({"flow.gradient"}, "flow.kind = \"gradient\"");
  }
  if (flow.kind == OrientationFlow::table) {
    checker.require("flow.table", why, "[[time, L11, L12, ... L33], ...]");
    check_times_of_rows("flow.table", flow.table, checker);
  } else {
    checker.warn_unused({"flow.table", "flow.form"}, "flow.kind = \"table\"");
  }
}

void validate_stress(const OrientationCase& values, CaseChecker& checker) {
  const OrientationFiberChoices& fibers = values.fibers;
  if (values.melt.name.empty()) {
    checker.warn_unused({"fibers.volume_fraction", "fibers.fiber_term", "fibers.trouton_term",
                         "flow.temperature", "flow.pressure"},
                        "a law under [melt]");
    return;
  }
  validate_law(viscosity_menu(), "melt", values.melt, checker);
  if (fibers.fiber_term && fibers.volume_fraction)
    checker.error("fibers.volume_fraction", "contradicts " + checker.cite("fibers.fiber_term"),
                  "remove one of the two");
  else if (!fibers.fiber_term && !fibers.volume_fraction)
    checker.error("fibers.fiber_term", "not given, nor is volume_fraction; the stress needs one",
                  "add fiber_term = 10 under [fibers]");
  else if (fibers.volume_fraction && !(fibers.aspect_ratio.value_or(0) > 1))
    checker.error("fibers.aspect_ratio",
                  "not given or not above 1; a volume fraction needs it for the stress",
                  "add aspect_ratio = 25 under [fibers], or give fiber_term");
}

/// Lists the gradients that the case gives: one, or one a row of its table.
std::vector<Mat3> given_gradients(const OrientationFlowChoices& flow) {
  if (flow.kind != OrientationFlow::table) return {constant_gradient(flow)};
  std::vector<Mat3> gradients;
  for (const std::vector<double>& row : flow.table) gradients.push_back(row_gradient(row, 1));
  return gradients;
}

void warn_of_doubts(const OrientationCase& values, CaseChecker& checker) {
  std::vector<std::string> told;
  const auto warn = [&](const char* key, const std::string& doubt, const char* remedy) {
    if (std::find(told.begin(), told.end(), key) != told.end()) return;  // once is enough for a whole table
    told.emplace_back(key);
    checker.warn(key, doubt, remedy);
  };
  for (const Mat3& gradient : given_gradients(values.flow)) {
    if (std::abs(gradient.trace()) > 1e-9 * gradient.cwiseAbs().maxCoeff())
      warn(values.flow.kind == OrientationFlow::table ? "flow.table" : "flow.gradient",
           fmt::format("the flow changes the volume: its divergence is {:.6g} 1/s", gradient.trace()),
           "give gradients without trace unless the melt is compressed");
    for (const std::string& doubt : doubts(orientation_model(values), values.fibers.orientation, gradient))
      warn("diffusion.name", doubt, "the tensor equation is still solved; judge its result with care");
  }
}

/// The harmonics of the chosen degree have to resolve the start.
void validate_start_of_distribution(const OrientationCase& values, CaseChecker& checker) {
  if (values.solution.distribution == DistributionChoice::no) return;
  try {
    const FokkerPlanck equation({}, static_cast<int>(values.solution.degree));
    static_cast<void>(equation.with_second_moment(values.fibers.orientation));
  } catch (const InputError& error) {
    checker.error("fibers.orientation", error.problems().front().complaint,
                  "raise solution.degree, or begin less aligned");
  }
}

}  // namespace

const LawMenu& diffusion_menu() {
  static const LawMenu menu = menu_of(rotary_diffusions());
  return menu;
}

const LawMenu& retardation_menu() {
  static const LawMenu menu = menu_of(retardations());
  return menu;
}

void validate_orientation(const OrientationCase& values, CaseChecker& checker) {
  validate_law(diffusion_menu(), "diffusion", values.diffusion, checker);
  validate_law(retardation_menu(), "retardation", values.retardation, checker);
  validate_flow(values.flow, checker);
  validate_stress(values, checker);
  validate_series(values.run, values.output, checker);
  if (values.solution.distribution == DistributionChoice::yes) {
    if (values.solution.degree % 2 != 0)
      checker.error("solution.degree", "not even", "fibers have no head and tail: take an even degree");
    if (values.retardation.name != "none" || values.fibers.potential != 0)
      checker.error("solution.distribution",
                    "a retardation or a potential acts on A2, not on the distribution",
                    "take distribution = \"no\", or no retardation and no potential");
    if (eigenframe(values.fibers.orientation).values[2] < 1e-9)
      checker.error("fibers.orientation",
                    "no smooth distribution of directions has a principal value of zero",
                    "give a small one, 0.01 say, or take distribution = \"no\"");
  } else {
    checker.warn_unused({"solution.degree"}, "solution.distribution = \"yes\"");
  }
  if (!checker.is_sound()) return;
  validate_start_of_distribution(values, checker);
  if (values.solution.steady == SteadyChoice::yes &&
      !(gradient_history(values.flow).at(values.run.duration).shear_rate() > 0))
    checker.error("solution.steady", "nothing deforms at the end of the run: every orientation stays",
                  "give a flow with a rate, or take steady = \"no\"");
  warn_of_doubts(values, checker);
}

double orientation_bytes(const OrientationCase& values) {
  constexpr double bytes_a_row = 600, bytes_a_coefficient = 2e3;
  const bool distribution = values.solution.distribution == DistributionChoice::yes;
  const double coefficients = 0.5 * std::pow(static_cast<double>(values.solution.degree), 2);
  return static_cast<double>(peak_memory_bytes()) +
         bytes_a_row * static_cast<double>(series_times(values.run, values.output).size()) +
         (distribution ? bytes_a_coefficient * coefficients : 0);
}

CaseEstimate estimate_orientation(const OrientationCase& values) {
  const Flow flow = gradient_history(values.flow).at(0);
  const double rate = flow.shear_rate();
  const Mat3 diffusion =
      rotary_diffusion(orientation_model(values), values.fibers.orientation, flow.gradient);
  CaseEstimate estimate;
  estimate.facts = {
      {"rate at the start", fmt::format("{:.6g} 1/s", rate)},
      {"strain, if it stayed so", fmt::format("{:.6g}", rate * values.run.duration)},
      {"equivalent C_I at the start", fmt::format("{:.6g}", diffusion.trace() / 3)},
      {"rows of series.csv", fmt::format("{}", series_times(values.run, values.output).size())}};
  estimate.memory_bytes = orientation_bytes(values);
  foretell(
      estimate, [&] { return orientation_seconds(values); }, "from a trial of its beginning");
  return estimate;
}

double fiber_term(const OrientationFiberChoices& fibers) {
  if (fibers.fiber_term) return *fibers.fiber_term;
  return *fibers.volume_fraction * particle_number(*fibers.aspect_ratio, *fibers.volume_fraction);
}

OrientationModel orientation_model(const OrientationCase& values) {
  OrientationModel model;
  model.diffusion = rotary_diffusion_named(values.diffusion.name);
  model.retardation = retardation_named(values.retardation.name);
  model.closure = closure_named(values.solution.closure);
  set_constants(model, diffusion_menu(), values.diffusion);
  set_constants(model, retardation_menu(), values.retardation);
  model.constants.xi = values.fibers.aspect_ratio ? shape_factor(*values.fibers.aspect_ratio) : 1;
  model.constants.u0 = values.fibers.potential;
  return model;
}

FlowHistory gradient_history(const OrientationFlowChoices& flow) {
  if (flow.kind != OrientationFlow::table) return FlowHistory::constant({constant_gradient(flow)});
  std::vector<FlowRow> rows;
  for (const std::vector<double>& row : flow.table) rows.push_back({row[0], {row_gradient(row, 1)}});
  return FlowHistory(std::move(rows), flow.form).in_steps(ramp_pieces);
}

}  // namespace fiberfate
