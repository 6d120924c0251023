// Makes synthetic experiments and calibrates laws to them.
#include "physics/process/synthetic_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/random.hpp"
#include "calibration/fit.hpp"
#include "continuum/length_prediction.hpp"
#include "continuum/length_registry.hpp"
#include "continuum/orientation_history.hpp"
#include "continuum/orientation_registry.hpp"

namespace fiberfate {
namespace {

/// A Couette run at one speed, L_N and L_W measured at several times, which reach both the decay and the
/// final length: where one is not observed, no interval is right.
struct Run {
  FlowHistory history;
  std::vector<double> times;
};

const std::vector<Run>& runs() {
  static const std::vector<Run> all = {{FlowHistory::constant(simple_shear(20)), {5, 10, 20, 40, 80, 150}},
                                       {FlowHistory::constant(simple_shear(40)), {2, 5, 10, 20, 40, 80}},
                                       {FlowHistory::constant(simple_shear(80)), {1, 2, 5, 10, 20, 40}}};
  return all;
}

/// Thin enough that L_ub, 1.6 to 2.1 mm, spans several bins: where it spans one or two, the lengths that
/// Phelps predicts are a staircase over zeta, with local minima on its steps.
const ViscosityLaw& melt() {
  static const auto law = make_viscosity_law("power_law", std::vector<double>{134, 0.73, 1e-3});
  return *law;
}

LengthStart pellets() {
  return {{{10e-3}, {1}}, {}, LengthForm::distribution, ClassWeight::length, {40, 10e-3}};
}

void predict_lengths(const std::string& name, std::span<const double> parameters,
                     std::vector<double>& lengths) {
  const auto law = make_attrition_law(name, parameters);
  // Relaxation laws keep one class, for which L_N and L_W are one number; Phelps tells them apart.
  for (const Run& run : runs())
    follow_lengths(*law, pellets(), {run.history, melt()}, run.times, [&](const LengthSample& sample) {
      lengths.push_back(sample.evolution.means().number_average);
      lengths.push_back(sample.evolution.means().weight_average);
    });
}

/// a11, a33 and a13 at five times, in three flows of rate 1/s.
void predict_orientation(const OrientationModel& model, std::vector<double>& components) {
  const OrientationLaw law(model);
  for (const Mat3& gradient :
       {simple_shear_gradient(), planar_elongation_gradient(), uniaxial_elongation_gradient()}) {
    const Mat3 start = Vec3(0.36, 0.33, 0.31).asDiagonal();
    OrientationIntegrator integrator(law, FlowHistory::constant({gradient}), {0, start}, {1e-9, 1e-9});
    for (const double time : {1.0, 2.0, 4.0, 7.0, 12.0}) {
      integrator.advance_to(time);
      const Mat3& second = integrator.state().second;
      components.insert(components.end(), {second(0, 0), second(2, 2), second(0, 2)});
    }
  }
}

std::vector<double> predict(const SyntheticCase& one, std::span<const double> values) {
  std::vector<double> predictions;
  if (one.kind == SyntheticCase::Kind::attrition) {
    std::vector<double> parameters;
    for (const LawParameter& parameter : find_attrition_law(one.law).parameters) {
      parameters.push_back(parameter.standard_value);
      for (std::size_t i = 0; i < values.size(); ++i)
        if (one.sought[i].name == parameter.name) parameters.back() = values[i];
      for (const TrueParameter& kept : one.kept)
        if (kept.name == parameter.name) parameters.back() = kept.value;
    }
    predict_lengths(one.law, parameters, predictions);
    return predictions;
  }
  OrientationModel model = orientation_model_named(one.law, "ibof");
  for (std::size_t i = 0; i < values.size(); ++i) set_constant(model, one.sought[i].name, values[i]);
  for (const TrueParameter& kept : one.kept) set_constant(model, kept.name, kept.value);
  predict_orientation(model, predictions);
  return predictions;
}

/// Length laws are searched by logarithms, from 20 % off, less for an exponent of a ratio of a million: L_inf
/// must stay below the fibers' length, or nothing breaks and no direction leads anywhere.
FitParameter sought_parameter(SyntheticCase::Kind kind, const TrueParameter& truth) {
  const double infinity = std::numeric_limits<double>::infinity();
  if (kind == SyntheticCase::Kind::orientation)
    return {truth.name,        "1",
            0.9 * truth.value, truth.name[0] == 'b' ? -1.0 : 0.0,
            infinity,          ParameterScale::linear};
  const double start = truth.name == "alpha" ? 1.02 : 1.2;
  return {truth.name, "1", start * truth.value, 0, infinity, ParameterScale::logarithmic};
}

}  // namespace

const std::vector<SyntheticCase>& synthetic_cases() {
  using enum SyntheticCase::Kind;
  static const std::vector<SyntheticCase> all = {
      {attrition, "constant", {{"k_f", 0.04}, {"L_inf", 1.1e-3}}, {}, 0.02},
      {attrition, "unbreakable_length", {{"lambda", 0.06}, {"xi", 1.5e-3}}, {}, 0.02},
      {attrition, "rate_power", {{"lambda", 1e-4}, {"alpha", 1}, {"xi", 2.4e-3}, {"beta", 0.84}}, {}, 0.02},
      {attrition,
       "stress_induced",
       {{"lambda", 4e-5}, {"alpha", 1.05}, {"k_0", 3e4}, {"beta", 0.95}},
       {},
       0.02},
      {attrition, "phelps", {{"C_B", 2.5e-3}, {"zeta", 3}, {"S", 0.25}}, {}, 0.02},
      {attrition, "durin", {{"C_B", 2.5e-3}, {"zeta", 3}, {"S", 0.25}}, {}, 0.02},
      {orientation, "jeffery", {{"xi", 0.8}}, {}, 0.01},
      {orientation, "folgar_tucker", {{"C_I", 0.02}}, {}, 0.01},
      {orientation, "rsc", {{"C_I", 0.02}, {"kappa", 0.4}}, {}, 0.01},
      {orientation, "srf", {{"C_I", 0.02}, {"srf", 0.4}}, {}, 0.01},
      // Five constants of nearly the same effect are told apart by better measurements only.
      {orientation,
       "ard",
       {{"b1", 0.01}, {"b2", 0.006}, {"b3", 0.03}, {"b4", 0.004}, {"b5", 0.01}},
       {},
       0.001},
      {orientation,
       "ard_rsc",
       {{"b1", 0.01}, {"b2", 0.006}, {"b3", 0.03}, {"b4", 0.004}, {"b5", 0.01}, {"kappa", 0.4}},
       {},
       0.001},
      {orientation, "iard", {{"C_I", 0.03}, {"C_M", 0.5}}, {}, 0.01},
      {orientation, "iard_rpr", {{"C_I", 0.03}, {"C_M", 0.5}, {"alpha", 0.5}}, {}, 0.01},
      {orientation, "pard", {{"C_I", 0.03}, {"Omega", 0.6}}, {}, 0.01},
      {orientation, "pard_rpr", {{"C_I", 0.03}, {"Omega", 0.6}, {"alpha", 0.5}}, {}, 0.01},
      {orientation, "mrd", {{"C_I", 0.03}, {"D2", 0.6}, {"D3", 0.4}}, {}, 0.01},
      {orientation, "wpt", {{"b1", 0.01}, {"b3", 0.02}}, {}, 0.01}};
  return all;
}

FitProblem pose(const SyntheticCase& one, std::uint64_t seed, std::uint32_t repetition) {
  FitProblem problem;
  std::vector<double> truth;
  for (const TrueParameter& parameter : one.sought) {
    truth.push_back(parameter.value);
    problem.parameters.push_back(sought_parameter(one.kind, parameter));
  }
  problem.model = [one](std::span<const double> values, std::span<double> predictions) {
    std::ranges::copy(predict(one, values), predictions.begin());
  };
  FitSeries series = {one.law, "1", predict(one, truth), {}};
  for (double& value : series.observed) {
    series.uncertainty.push_back(one.kind == SyntheticCase::Kind::attrition ? one.noise * value : one.noise);
    const auto i = static_cast<std::uint32_t>(series.uncertainty.size());
    value += series.uncertainty.back() * normal2(seed, RandomStream::noise, {repetition, i})[0];
  }
  problem.series.push_back(series);
  return problem;
}

Coverage count_held(const SyntheticCase& one, std::uint64_t seed, std::uint32_t repetitions) {
  Coverage coverage{std::vector<int>(one.sought.size(), 0), 0, repetitions};
  for (std::uint32_t repetition = 0; repetition < repetitions; ++repetition) {
    const FitResult result = fit(pose(one, seed, repetition));
    bool determined = result.converged;
    for (std::size_t k = 0; k < one.sought.size(); ++k) {
      const ParameterEstimate& found = result.parameters[k];
      determined = determined && found.outcome == ParameterOutcome::determined;
      const double truth = one.sought[k].value;
      coverage.held[k] += found.interval.lower <= truth && truth <= found.interval.upper ? 1 : 0;
    }
    if (!determined) ++coverage.undetermined;
  }
  return coverage;
}

}  // namespace fiberfate
